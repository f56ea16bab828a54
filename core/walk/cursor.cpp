#include "core/walk/cursor.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr std::size_t most_undone = 10'000; // a script may go on for long

} // namespace

Moved Cursor::go_to(std::size_t moment) {
    if (before_.size() == most_undone) before_.erase(before_.begin(), before_.begin() + most_undone / 2);
    before_.push_back(moment_);
    moment_ = moment;
    return Moved::yes;
}

Moved Cursor::step() { return moment_ + 1 < timeline_->size() ? go_to(moment_ + 1) : Moved::at_end; }

Moved Cursor::step_back() { return moment_ > 0 ? go_to(moment_ - 1) : Moved::at_start; }

Moved Cursor::next() {
    const auto& rays = timeline_->rays();
    const auto after =
        std::ranges::upper_bound(rays, moment_, {}, [&](int ray) { return timeline_->start(ray); });
    return after == rays.end() ? Moved::at_end : go_to(timeline_->start(*after));
}

Moved Cursor::back() {
    const auto& rays = timeline_->rays();
    const auto at_or_after =
        std::ranges::lower_bound(rays, moment_, {}, [&](int ray) { return timeline_->start(ray); });
    return at_or_after == rays.begin() ? Moved::at_start : go_to(timeline_->start(*(at_or_after - 1)));
}

Moved Cursor::in() {
    for (const int child : ray().children)
        if (timeline_->start(child) > moment_) return go_to(timeline_->start(child));
    return Moved::no_child;
}

Moved Cursor::back_into() {
    const auto& children = ray().children;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
        if (timeline_->start(*child) < moment_) {
            const auto last = int(trace_->rays[std::size_t(*child)].events.size()) - 1;
            return go_to(Spot{*child, last});
        }
    return Moved::no_child;
}

Moved Cursor::over() {
    const Spot here = spot();
    if (here.event > 0) {
        const bool last = std::size_t(here.event) + 1 == ray().events.size();
        return last ? out() : go_to(Spot{here.ray, here.event + 1});
    }
    if (ray().parent == none) return Moved::no_sibling;
    for (const int sibling : trace_->rays[std::size_t(ray().parent)].children)
        if (timeline_->start(sibling) > moment_) return go_to(timeline_->start(sibling));
    return out();
}

Moved Cursor::back_over() {
    const Spot here = spot();
    if (here.event > 0) return go_to(Spot{here.ray, here.event - 1});
    if (ray().parent == none) return Moved::at_start;
    const auto& siblings = trace_->rays[std::size_t(ray().parent)].children;
    for (auto sibling = siblings.rbegin(); sibling != siblings.rend(); ++sibling)
        if (timeline_->start(*sibling) < moment_) return go_to(timeline_->start(*sibling));
    return back_out();
}

Moved Cursor::out() {
    if (ray().parent == none) return Moved::no_parent;
    const std::size_t after = timeline_->end(spot().ray) + 1;
    // Of a parent whose record ends with this ray nothing comes after; then its last event before.
    if (after < timeline_->size() && timeline_->at(after).ray == ray().parent) return go_to(after);
    const auto last = int(trace_->rays[std::size_t(ray().parent)].events.size()) - 1;
    return go_to(Spot{ray().parent, last});
}

Moved Cursor::back_out() {
    if (ray().parent == none) return Moved::no_parent;
    int event = 0;
    const auto& events = trace_->rays[std::size_t(ray().parent)].events;
    const std::size_t start = timeline_->start(spot().ray);
    while (std::size_t(event) + 1 < events.size() && timeline_->moment({ray().parent, event + 1}) < start)
        ++event;
    return go_to(Spot{ray().parent, event});
}

Moved Cursor::go_on(const Stop& stop) {
    for (std::size_t moment = moment_ + 1; moment < timeline_->size(); ++moment)
        if (stop(moment)) return go_to(moment);
    if (moment_ + 1 < timeline_->size()) (void)go_to(timeline_->size() - 1);
    return Moved::at_end;
}

Moved Cursor::go_back(const Stop& stop) {
    for (std::size_t moment = moment_; moment-- > 0;)
        if (stop(moment)) return go_to(moment);
    if (moment_ > 0) (void)go_to(std::size_t(0));
    return Moved::at_start;
}

Moved Cursor::undo() {
    if (before_.empty()) return Moved::nothing_before;
    moment_ = before_.back();
    before_.pop_back();
    return Moved::yes;
}

} // namespace rayscope
