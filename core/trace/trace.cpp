#include "core/trace/trace.hpp"

namespace rayscope {

std::optional<double> end_of(const TracedRay& ray) {
    if (const auto* hit = ray.find<BoundaryChosen>()) return hit->boundary.t;
    if (std::isfinite(ray.start().reach)) return ray.start().reach;
    return std::nullopt;
}

std::vector<SpanFound> spans_after(const TracedRay& ray, std::size_t index) {
    const auto& node = std::get<NodeEvaluated>(ray.events.at(index));
    std::vector<SpanFound> found;
    for (std::size_t i = index + 1; i < ray.events.size() && int(found.size()) < node.count; ++i) {
        const auto* span = std::get_if<SpanFound>(&ray.events[i]);
        if (span == nullptr) break; // the trace was truncated here
        found.push_back(*span);
    }
    return found;
}

} // namespace rayscope
