#include "visualizer/drawing/lanes.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

/// Inside somewhere between the start and `limit`.
bool meets(const std::vector<Lane>& group, double limit) {
    return std::ranges::any_of(group, [&](const Lane& lane) {
        return std::ranges::any_of(
            lane.spans, [&](const SpanFound& span) { return span.exit.t > 0 && span.enter.t < limit; });
    });
}

const TraceObject* object_of(const Trace& trace, Id object) {
    return object >= 0 && std::size_t(object) < trace.objects.size() ? &trace.objects[std::size_t(object)]
                                                                     : nullptr;
}

} // namespace

std::string lane_label(const Trace& trace, Id object, Id node) {
    const TraceObject* owner = object_of(trace, object);
    if (owner == nullptr) return {};
    if (node < 0 || std::size_t(node) >= owner->nodes.size()) return owner->name;
    const bool root = std::size_t(node) + 1 == owner->nodes.size();
    const std::string& text = owner->nodes[std::size_t(node)].name;
    if (!root || owner->nodes.size() == 1) return text.empty() ? owner->name : text;
    return text.empty() || text == owner->name ? owner->name : owner->name + " = " + text;
}

Lanes lanes_of(const Trace& trace, const TracedRay& ray, std::size_t most) {
    std::vector<std::vector<Lane>> groups; // one for each object
    for (std::size_t i = 0; i < ray.events.size(); ++i) {
        const auto* node = std::get_if<NodeEvaluated>(&ray.events[i]);
        if (node == nullptr) continue;
        if (groups.empty() || groups.back().front().object != node->object) groups.emplace_back();
        const TraceObject* owner = object_of(trace, node->object);
        const bool root = owner != nullptr && node->node + 1 == Id(owner->nodes.size());
        groups.back().push_back({node->object,
                                 node->node,
                                 lane_label(trace, node->object, node->node),
                                 {},
                                 root,
                                 spans_after(ray, i)});
    }
    const auto* hit = ray.find<BoundaryChosen>();
    const double limit = hit != nullptr ? far_behind * hit->boundary.t : infinity<double>;
    const auto rank = [&](const std::vector<Lane>& group) {
        if (hit != nullptr && group.front().object == hit->object) return 0;
        return meets(group, limit) ? 1 : 2;
    };
    std::ranges::stable_sort(groups, std::less{}, rank);
    Lanes lanes;
    for (const auto& group : groups) {
        if (rank(group) == 2) continue;
        std::size_t colour = 0;
        for (Lane lane : group) {
            // A compound's root is dark; a plain solid has its only lane in a colour.
            lane.colour = lane_colour(colour++ + (rank(group) == 0 ? 0 : lanes.shown.size()),
                                      lane.root && group.size() > 1);
            // Of what was hit, the last lane shown is the root, even if others must go.
            if (lanes.shown.size() < most)
                lanes.shown.push_back(std::move(lane));
            else {
                ++lanes.hidden;
                if (lane.root && rank(group) == 0) lanes.shown.back() = std::move(lane);
            }
        }
    }
    return lanes;
}

} // namespace rayscope::drawing
