#include "core/walk/timeline.hpp"

namespace rayscope {
namespace {

/// Before which of its parent's events each child starts: shadow rays before the light that they ask for is summed up,
/// the others after the decision that sends them. Where a full record has lost that event, before it says that it is
/// full.
std::vector<int> starts_of_children(const Trace& trace, const TracedRay& ray) {
    const auto count = int(ray.events.size());
    int late = count;
    for (int i = count - 1; i > 0; --i)
        if (std::holds_alternative<RayFinished>(ray.events[std::size_t(i)]) ||
            std::holds_alternative<Truncated>(ray.events[std::size_t(i)]))
            late = i;
    std::vector<int> starts;
    int least = 1; // children come in the order of spawning
    for (const int child : ray.children) {
        const RaySpawned& start = trace.rays[std::size_t(child)].start();
        int at = late;
        for (int i = least; i < count && at == late; ++i) {
            const Event& event = ray.events[std::size_t(i)];
            if (const auto* lit = std::get_if<LightLit>(&event);
                lit && start.kind == RayKind::shadow && lit->light == start.light)
                at = i;
            if ((start.kind == RayKind::reflected && std::holds_alternative<Reflected>(event)) ||
                (start.kind == RayKind::refracted && std::holds_alternative<Refracted>(event)))
                at = i + 1;
        }
        least = std::max(least, at);
        starts.push_back(least);
    }
    return starts;
}

/// A ray that is under way: what of it comes next.
struct Open {
    int ray;
    int event = 0;
    std::size_t child = 0;
    std::vector<int> starts;
};

} // namespace

Timeline::Timeline(const Trace& trace) {
    std::size_t count = 0;
    for (const TracedRay& ray : trace.rays) {
        first_.push_back(count);
        count += ray.events.size();
    }
    spots_.reserve(count);
    moments_.resize(count);
    ends_.resize(trace.rays.size());
    // The stack is explicit: a trace from a file may be a chain of any length.
    std::vector<Open> open{{0, 0, 0, starts_of_children(trace, trace.rays[0])}};
    while (!open.empty()) {
        Open& now = open.back();
        const TracedRay& ray = trace.rays[std::size_t(now.ray)];
        if (now.child < ray.children.size() && now.starts[now.child] <= now.event) {
            const int child = ray.children[now.child++];
            open.push_back({child, 0, 0, starts_of_children(trace, trace.rays[std::size_t(child)])});
            continue;
        }
        if (std::size_t(now.event) == ray.events.size()) {
            ends_[std::size_t(now.ray)] = spots_.size() - 1;
            open.pop_back();
            continue;
        }
        if (now.event == 0) rays_.push_back(now.ray);
        moments_[first_[std::size_t(now.ray)] + std::size_t(now.event)] = spots_.size();
        spots_.push_back({now.ray, now.event++});
    }
}

} // namespace rayscope
