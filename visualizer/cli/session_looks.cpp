// Commands that show something and move nothing.

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/bars_text.hpp"
#include "visualizer/cli/event_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/refraction_text.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/cli/value_text.hpp"
#include "visualizer/cli/why_text.hpp"

#include <algorithm>
#include <sstream>

namespace rayscope::cli {
namespace {

const Command& command_named(const std::string& word) {
    std::vector<std::string_view> names;
    for (const Command& command : commands()) {
        std::istringstream aliases{std::string(command.aliases)};
        for (std::string alias; aliases >> alias;)
            if (alias == word) return command;
        if (command.name == word) return command;
        names.push_back(command.name);
    }
    throw UsageError("help: no command is called " + in_quotes(word) + did_you_mean(word, names));
}

void add_command(Page& page, const Command& command) {
    const std::string first(command.aliases.substr(0, command.aliases.find(' ')));
    const std::string argument = command.argument.empty() ? "" : " " + std::string(command.argument);
    page.item(std::string(command.name) + (first.empty() ? "" : ", " + first),
              (argument.empty() ? "" : argument.substr(1) + ": ") + std::string(command.help));
}

/// As a person types it: both spellings are known.
std::string with_dashes(std::string name) {
    std::ranges::replace(name, '_', '-');
    return name;
}

} // namespace

std::string Session::energy(const std::string& /*nothing*/) { return ledger_text(trace(), style_); }

std::string Session::tree(const std::string& /*nothing*/) { return tree_text(trace(), style_, current()); }

std::string Session::path(const std::string& /*nothing*/) {
    std::vector<int> rays;
    for (int ray = current(); ray != none; ray = trace().rays[std::size_t(ray)].parent) rays.push_back(ray);
    constexpr std::size_t most = 64;
    const std::size_t left_out = rays.size() > most ? rays.size() - most : 0;
    std::ranges::reverse(rays);
    Page page(style_.paint);
    for (std::size_t i = left_out; i < rays.size(); ++i) {
        const TracedRay& ray = trace().rays[std::size_t(rays[i])];
        const auto* hit = ray.find<BoundaryChosen>();
        const RayKind kind = ray.start().kind;
        page.line(style_.paint.kind(kind, std::to_string(rays[i]) + " " + name_of(kind)) + ", depth " +
                      std::to_string(ray.start().depth) + ", weight " + style_.number(weight(ray)) +
                      (hit == nullptr ? ""
                                      : ", to " + object_name(trace(), hit->object) +
                                            " at t = " + style_.number(hit->boundary.t)) +
                      (i + 1 == rays.size() ? " " + style_.paint.bold("◄") : ""),
                  2 * std::min<std::size_t>(i - left_out, 12));
    }
    return page.text();
}

std::string Session::ray(const std::string& number) {
    const int last = int(trace().rays.size()) - 1;
    return ray_text(trace(), number.empty() ? current() : parse_count("ray", number, 0, last), style_);
}

std::string Session::event(const std::string& /*nothing*/) { return event_text(walk_.here(), style_, true); }

std::string Session::list(const std::string& count) {
    const std::size_t wanted = count.empty() ? 10 : std::size_t(parse_count("list", count, 1, 10000));
    const std::size_t here = cursor().moment(), all = walk_.timeline().size();
    const std::size_t first =
        here > wanted / 2 ? std::min(here - wanted / 2, all - std::min(all, wanted)) : 0;
    std::string text;
    for (std::size_t moment = first; moment < std::min(all, first + wanted); ++moment)
        text += (moment == here ? "► " : "  ") + event_text(walk_.walked().seen(moment), style_, false);
    return text;
}

std::string Session::spans(const std::string& t) {
    std::optional<double> sweep;
    if (!t.empty()) sweep = parse_number("spans", t);
    return bars_text(trace(), current(), sweep, style_);
}

std::string Session::hit(const std::string& /*nothing*/) {
    Page page(style_.paint);
    add_hit(page, trace(), current(), style_);
    return page.text().empty()
               ? "A shadow ray asks for a light, and stops nowhere: spans shows what it meets.\n"
               : page.text();
}

std::string Session::light(const std::string& /*nothing*/) {
    Page page(style_.paint);
    add_light(page, trace(), current(), style_);
    return page.text().empty() ? "This ray has no hit that could be lit.\n" : page.text();
}

std::string Session::refraction(const std::string& /*nothing*/) {
    return refraction_text(trace(), current(), style_);
}

std::string Session::colour(const std::string& /*nothing*/) { return result_text(trace(), style_); }

std::string Session::print(const std::string& text) {
    const Expression expression = read_expression("print", text);
    return harmless(text) + " = " + value_text(expression.value(walk_.here()), expression, style_.number) +
           "\n";
}

std::string Session::info(const std::string& topic) {
    Page page(style_.paint);
    if (topic.empty() || topic == "b" || std::string("breakpoints").starts_with(topic)) return stops_text();
    if (std::string("display").starts_with(topic))
        return displays_.empty() ? "Nothing is displayed.\n" : displays_text();
    if (std::string("scene").starts_with(topic)) {
        page.item("scene", harmless(bench_.scene.file));
        page.item("drawn", std::to_string(bench_.scene.drawn.size()) + " objects");
        page.item("lights", std::to_string(bench_.scene.lights.size()));
        page.item("limits", "max_depth " + std::to_string(trace().max_depth) + ", min_weight " +
                                style_.number(trace().min_weight));
        return page.text();
    }
    if (!std::string("fields").starts_with(topic))
        throw UsageError("info: expected breakpoints, display, scene or fields, found " + in_quotes(topic));
    page.heading("Words for what happens");
    for (const auto& [name, field] : fields())
        if (field.derived != nullptr && field.help != "the event of that name")
            page.item(with_dashes(name), std::string(field.help));
    page.heading("Members of events, each named as in the trace's JSON");
    std::string members;
    for (const auto& [name, field] : fields())
        if (std::ranges::any_of(field.of_event, [](auto reader) { return reader != nullptr; }))
            members += (members.empty() ? "" : " ") + name;
    page.line(members, 2);
    page.line(
        "A bare name is the ray's where rays have it (depth, weight, origin, …); EVENT.NAME is that event's: "
        "refracted.direction.x. Angles are in degrees.",
        2);
    return page.text();
}

std::string Session::help(const std::string& word) {
    Page page(style_.paint);
    if (!word.empty()) {
        const Command& command = command_named(word);
        add_command(page, command);
        if (command.aliases.find(' ') != std::string_view::npos)
            page.item("also", std::string(command.aliases));
        return page.text();
    }
    for (const Command& command : commands()) add_command(page, command);
    page.line(
        "The beginning of a name is enough where no other begins so. An empty line repeats the last command.",
        2);
    return page.text();
}

} // namespace rayscope::cli
