// Commands that say where to stop, what to show after each move, and what to look for.

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/find_text.hpp"
#include "visualizer/cli/progress.hpp"
#include "visualizer/cli/second_run.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/cli/value_text.hpp"

#include <algorithm>
#include <limits>

namespace rayscope::cli {
namespace {

/// "$" is the one that was set last.
int stop_number(const char* command, const std::string& text, const StopPoints& stops) {
    if (text == "$" && !stops.all().empty()) return stops.all().back().number;
    return parse_count(command, text, 1, std::numeric_limits<int>::max());
}

[[noreturn]] void no_stop(const char* command, const std::string& number) {
    throw UsageError(std::string(command) + ": there is no breakpoint or watch " + number);
}

} // namespace

Expression Session::read_expression(const char* command, const std::string& text) const {
    Vocabulary vocabulary = vocabulary_of(bench_.scene);
    vocabulary.divergence = has_second_run_;
    return expression_of(command, text, vocabulary);
}

std::string Session::set_break(const std::string& condition) {
    if (condition.empty()) return stops_text();
    Expression expression = read_expression("break", condition);
    need_condition("break", expression);
    const int number = walk_.stops().add_breakpoint(std::move(expression));
    return "Breakpoint " + std::to_string(number) + ": " + harmless(condition) + "\n";
}

std::string Session::set_break_once(const std::string& condition) {
    Expression expression = read_expression("tbreak", condition);
    need_condition("tbreak", expression);
    const int number = walk_.stops().add_breakpoint(std::move(expression), true);
    return "Breakpoint " + std::to_string(number) + ", once: " + harmless(condition) + "\n";
}

std::string Session::set_watch(const std::string& text) {
    Expression expression = read_expression("watch", text);
    const Value now = latest_value(expression, walk_.walked(), cursor().moment());
    const std::string value = value_text(now, expression, style_.number);
    const int number = walk_.stops().add_watch(std::move(expression));
    return "Watch " + std::to_string(number) + ": " + harmless(text) + ", now " + value + "\n";
}

std::string Session::remove(const std::string& number) {
    if (number.empty()) {
        walk_.stops().clear();
        return "No breakpoints or watches are left.\n";
    }
    if (!walk_.stops().remove(stop_number("delete", number, walk_.stops()))) no_stop("delete", number);
    return stops_text();
}

std::string Session::enable(const std::string& number) {
    for (const StopPoint& point : std::vector(walk_.stops().all()))
        if (number.empty()) (void)walk_.stops().enable(point.number, true);
    if (!number.empty() && !walk_.stops().enable(stop_number("enable", number, walk_.stops()), true))
        no_stop("enable", number);
    return stops_text();
}

std::string Session::disable(const std::string& number) {
    for (const StopPoint& point : std::vector(walk_.stops().all()))
        if (number.empty()) (void)walk_.stops().enable(point.number, false);
    if (!number.empty() && !walk_.stops().enable(stop_number("disable", number, walk_.stops()), false))
        no_stop("disable", number);
    return stops_text();
}

std::string Session::stops_text() const {
    if (walk_.stops().all().empty())
        return "There are no breakpoints and no watches: break tir, break depth >= 4, watch weight.\n";
    Page page(style_.paint);
    for (const StopPoint& point : walk_.stops().all())
        page.item(std::to_string(point.number) + (point.watches ? " watch" : " break"),
                  harmless(point.expression.text()) + (point.once ? ", once" : "") +
                      (point.enabled ? "" : ", disabled") + ", stopped " + std::to_string(point.hits) +
                      (point.hits == 1 ? " time" : " times"));
    return page.text();
}

std::string Session::reasons_text() const {
    std::string text;
    for (const StopReason& reason : walk_.reasons()) {
        text += (reason.watches ? "watch " : "breakpoint ") + std::to_string(reason.number) + ": " +
                harmless(reason.expression);
        for (const StopPoint& point : walk_.stops().all())
            if (reason.watches && point.number == reason.number)
                text += ": " + value_text(reason.before, point.expression, style_.number) + " → " +
                        value_text(reason.now, point.expression, style_.number);
        text += "\n";
    }
    return text;
}

std::string Session::display(const std::string& text) {
    if (text.empty()) return displays_.empty() ? "Nothing is displayed.\n" : displays_text();
    constexpr std::size_t most = 50;
    if (displays_.size() >= most) throw UsageError("display: at most " + std::to_string(most) + " at once");
    displays_.push_back({++last_display_, read_expression("display", text)});
    return displays_text();
}

std::string Session::undisplay(const std::string& number) {
    if (number.empty()) {
        displays_.clear();
        return "Nothing is displayed any more.\n";
    }
    const int asked = parse_count("undisplay", number, 1, std::numeric_limits<int>::max());
    if (std::erase_if(displays_, [&](const Display& display) { return display.number == asked; }) == 0)
        throw UsageError("undisplay: there is no display " + number);
    return displays_.empty() ? "Nothing is displayed any more.\n" : displays_text();
}

std::string Session::displays_text() const {
    std::string text;
    for (const Display& display : displays_)
        text += std::to_string(display.number) + ": " + harmless(display.expression.text()) + " = " +
                value_text(display.expression.value(walk_.here()), display.expression, style_.number) + "\n";
    return text;
}

std::string Session::find(const std::string& text) {
    Vocabulary vocabulary = vocabulary_of(bench_.scene);
    const Expression condition = expression_of("find", text, vocabulary);
    need_condition("find", condition);
    FindOptions options;
    options.by_stage = choice_.by_stage;
    options.render.stage = choice_.stage;
    need_stage("find", condition, options.by_stage);
    FindResult result;
    {
        Progress progress("looking");
        options.render.progress = [&](double share) { progress.show(share); };
        result = rayscope::find(bench_.scene, bench_.world, condition, options);
    }
    const std::string said = find_text(bench_, condition, result, options, 12, style_);
    found_.reset();
    if (result.pixels == 0) return said;
    found_ = {text, std::move(result)};
    return said + "pixel X,Y goes to one of them.\n";
}

std::string Session::compare(const std::string& what) {
    const SecondRun second = second_run("diff", what, bench_, trace());
    const Comparison comparison = compared(second, bench_, trace());
    has_second_run_ = comparison.divergence.has_value();
    walk_.set_divergence(has_second_run_ ? std::optional(spot_of(trace(), *comparison.divergence))
                                         : std::nullopt);
    return second_run_text(second, bench_, trace(), style_) +
           (has_second_run_ ? "\nbreak divergence stops there.\n" : "");
}

std::string Session::quiz(const std::string& /*nothing*/) {
    std::vector<std::string> names;
    for (const SceneObject& drawn : bench_.scene.drawn) {
        names.push_back(object_title(bench_.scene, drawn));
        if (names.size() == 8) break; // of which a few are offered
    }
    quiz_.emplace(walk_, names);
    const std::string text = quiz_->begin(walk_, style_);
    if (quiz_->ended()) quiz_.reset();
    return text;
}

} // namespace rayscope::cli
