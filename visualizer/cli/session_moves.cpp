// Commands that go somewhere.

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/event_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/session.hpp"

#include <charconv>

namespace rayscope::cli {
namespace {

constexpr int most_times = 1'000'000;

std::string why_it_stays(Moved moved) {
    switch (moved) {
    case Moved::yes: break;
    case Moved::at_start: return "Nothing happened before.\n";
    case Moved::at_end: return "That was the last of it: colour sums up, goto 0 starts again.\n";
    case Moved::no_child: return "This ray spawns none from here on: next or over go on.\n";
    case Moved::no_sibling: return "The first ray has no sibling: in goes to the rays that it spawned.\n";
    case Moved::no_parent: return "This is the first ray: nothing spawned it.\n";
    case Moved::nothing_before: return "This is where you began.\n";
    }
    return "";
}

std::optional<int> whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || text.empty() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

int times_of(const char* name, const std::string& text) {
    return text.empty() ? 1 : parse_count(name, text, 1, most_times);
}

} // namespace

std::string Session::next(const std::string& times) { return move(&Cursor::next, "next", times); }
std::string Session::back(const std::string& times) { return move(&Cursor::back, "back", times); }
std::string Session::step(const std::string& times) { return move(&Cursor::step, "step", times); }
std::string Session::step_back(const std::string& times) {
    return move(&Cursor::step_back, "reverse-step", times);
}
std::string Session::in(const std::string& times) { return move(&Cursor::in, "in", times); }
std::string Session::back_into(const std::string& times) {
    return move(&Cursor::back_into, "reverse-in", times);
}
std::string Session::over(const std::string& times) { return move(&Cursor::over, "over", times); }
std::string Session::back_over(const std::string& times) {
    return move(&Cursor::back_over, "reverse-over", times);
}
std::string Session::out(const std::string& times) { return move(&Cursor::out, "out", times); }
std::string Session::back_out(const std::string& times) {
    return move(&Cursor::back_out, "reverse-out", times);
}
std::string Session::undo(const std::string& times) { return move(&Cursor::undo, "undo", times); }

std::string Session::move(Move way, const char* name, const std::string& times) {
    Moved moved = Moved::yes;
    int made = 0;
    for (const int asked = times_of(name, times); made < asked && moved == Moved::yes; ++made)
        moved = (walk_.cursor().*way)();
    // Of several moves the last ones may have found nothing left to do.
    return made > 1 && moved != Moved::yes ? why_it_stays(moved) + place_text() : moved_text(moved);
}

std::string Session::moved_text(Moved moved) const {
    return moved == Moved::yes ? place_text() : why_it_stays(moved);
}

std::string Session::place_text() const {
    const std::string text = cursor().at_ray_start() ? ray_text(trace(), current(), style_)
                                                     : event_text(walk_.here(), style_, true);
    return text + displays_text();
}

std::string Session::go_on(const std::string& times) {
    for (int left = times_of("continue", times); left > 1 && walk_.go_on() == Moved::yes;) --left;
    return walk_.go_on() == Moved::yes ? reasons_text() + place_text()
                                       : "Nothing stops any more: this is the end.\n" + place_text();
}

std::string Session::go_back(const std::string& times) {
    for (int left = times_of("reverse-continue", times); left > 1 && walk_.go_back() == Moved::yes;) --left;
    return walk_.go_back() == Moved::yes ? reasons_text() + place_text()
                                         : "Nothing stopped before: this is the start.\n" + place_text();
}

std::string Session::until(const std::string& condition) {
    const Expression expression = read_expression("until", condition);
    if (expression.type() != ValueType::condition)
        throw UsageError("until: expected a condition, such as 'depth >= 3'");
    const WalkedTrace walked = walk_.walked();
    const std::size_t before = cursor().moment();
    const auto holds = [&](std::size_t moment) { return expression.holds(walked.seen(moment)); };
    if (walk_.cursor().go_on(holds) == Moved::yes) return place_text();
    if (cursor().moment() != before) (void)walk_.cursor().undo();
    return "It holds nowhere after this.\n";
}

std::string Session::go_to(const std::string& place) {
    const std::size_t rays = trace().rays.size();
    if (place == "start" || place == "end")
        return moved_text(walk_.cursor().go_to(place == "start" ? 0 : walk_.timeline().size() - 1));
    const std::size_t dot = std::min(place.find('.'), place.size());
    const auto ray = whole_number(std::string_view(place).substr(0, dot));
    if (!ray || *ray < 0 || std::size_t(*ray) >= rays)
        throw UsageError("goto: expected a ray from 0 to " + std::to_string(rays - 1) + ", found " +
                         in_quotes(place));
    int event = 0;
    if (dot < place.size()) {
        const std::size_t events = trace().rays[std::size_t(*ray)].events.size();
        const auto number = whole_number(std::string_view(place).substr(dot + 1));
        if (!number || *number < 0 || std::size_t(*number) >= events)
            throw UsageError("goto: expected an event from 0 to " + std::to_string(events - 1) + " of ray " +
                             std::to_string(*ray) + ", found " + in_quotes(place.substr(dot + 1)));
        event = *number;
    }
    return moved_text(walk_.cursor().go_to(Spot{*ray, event}));
}

std::string Session::pixel(const std::string& place) {
    RayChoice choice = choice_;
    choice.ray.reset();
    choice.pixel = parse_pixel(place);
    walk_.start_again(trace_choice(bench_, choice));
    has_second_run_ = false;
    return tree_text(trace(), style_) + place_text();
}

} // namespace rayscope::cli
