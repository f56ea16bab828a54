#include "core/trace/span_counts.hpp"

#include "core/trace/events_of.hpp"

#include <algorithm>
#include <map>

namespace rayscope {
namespace {

/// A shadow ray that is blocked asks no further, and a stage tests what may matter: of other objects nothing is known.
bool tested_some(const TracedRay& ray) {
    const auto* end = ray.start().kind == RayKind::shadow ? ray.find<RayFinished>() : nullptr;
    return has_event<SearchBegan>(ray) || (end != nullptr && end->colour == Colour{0});
}

using Counts = std::map<Id, int>;                                // spans of each node
using Inside = std::vector<std::pair<std::string_view, Counts>>; // of each object, as they were tested

Inside inside_of(const Trace& trace, const TracedRay& ray) {
    Inside inside;
    for (const NodeEvaluated* event : events_of<NodeEvaluated>(ray)) {
        const std::string_view name = trace.objects[std::size_t(event->object)].name;
        auto at = std::ranges::find(inside, name, &Inside::value_type::first);
        if (at == inside.end()) at = inside.insert(at, {name, {}});
        at->second[event->node] = event->count;
    }
    return inside;
}

/// What the first has and the second does not. What the line misses is not recorded.
/// @param all_there the second was tested against everything
std::optional<SpanCountDifference> not_in(const Inside& here, const Inside& there, bool all_there) {
    for (const auto& [name, counts] : here) {
        const auto found = std::ranges::find(there, name, &Inside::value_type::first);
        if (found == there.end() && !all_there) continue;
        for (const auto& [node, count] : counts) {
            const auto other = found == there.end() ? counts.end() : found->second.find(node);
            const bool known = found != there.end() && other != found->second.end();
            const int there_count = known ? other->second : 0;
            if (count != there_count) return SpanCountDifference{name, node, count, there_count};
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<SpanCountDifference> first_span_difference(const Trace& first, const TracedRay& a,
                                                         const Trace& second, const TracedRay& b) {
    const Inside in_a = inside_of(first, a), in_b = inside_of(second, b);
    if (const auto found = not_in(in_a, in_b, !tested_some(b))) return found;
    auto found = not_in(in_b, in_a, !tested_some(a));
    if (found) std::swap(found->first, found->second);
    return found;
}

} // namespace rayscope
