#include "core/trace/recorder.hpp"

#include <algorithm>

namespace rayscope {

void TraceRecorder::record(const Event& event) {
    const bool spawned = std::holds_alternative<RaySpawned>(event);
    const bool finished = std::holds_alternative<RayFinished>(event);
    const int current = open_.empty() ? none : open_.back();
    // Rays that were opened are closed properly even when no more is kept.
    const bool keep = finished ? current != none : !full() && (spawned || current != none);
    if (!keep && dropped_++ == 0 && current != none)
        rays_[std::size_t(current)].events.push_back(Truncated{int(kept_)});
    if (spawned) {
        open_.push_back(keep ? int(rays_.size()) : none);
        if (!keep) return;
        if (current != none) rays_[std::size_t(current)].children.push_back(open_.back());
        rays_.push_back({current, {}, {}});
    }
    if (keep) {
        ++kept_;
        std::vector<Event>& events = rays_[std::size_t(open_.back())].events;
        events.push_back(event);
        if (finished) {
            auto& end = std::get<RayFinished>(events.back());
            end.rejected = end.tested - int(std::count_if(events.begin(), events.end(), [](const Event& e) {
                               return std::holds_alternative<ObjectAccepted>(e);
                           }));
        }
    }
    if (finished) open_.pop_back();
}

} // namespace rayscope
