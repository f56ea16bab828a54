#include "exercises/grader/cut_code.hpp"
#include "exercises/grader/event_case.hpp"

namespace rayscope::exercises {
namespace {

/// The node whose spans the event belongs to.
std::optional<std::size_t> node_event(const EventPlace& place) {
    std::size_t i = place.index;
    while (i > 0 && std::holds_alternative<SpanFound>(place.ray.events[i])) --i;
    if (!std::holds_alternative<NodeEvaluated>(place.ray.events[i])) return std::nullopt;
    return i;
}

/// The spans of a node of the same object; none if the line misses it, which is not recorded.
std::vector<SpanFound> spans_of(const TracedRay& ray, Id object, Id node) {
    for (std::size_t i = 0; i < ray.events.size(); ++i)
        if (const auto* found = std::get_if<NodeEvaluated>(&ray.events[i]);
            found != nullptr && found->object == object && found->node == node)
            return spans_after(ray, i);
    return {};
}

EventCase hits_case(const std::vector<SpanFound>& spans) {
    std::vector<std::string> hits;
    for (const SpanFound& span : spans)
        for (const auto& [end, enters] : {std::pair(&span.enter, true), std::pair(&span.exit, false)})
            if (std::isfinite(end->t))
                hits.push_back(fmt::format("{{{}, dvec3(0, 0, 1), {}, 0}}", code(end->t), enters));
    return {"2-01-inside-list", list_code("Hits", hits)};
}

char symbol(Operation operation) {
    switch (operation) {
    case Operation::leaf: return '.';
    case Operation::set_union: return '|';
    case Operation::intersection: return '&';
    case Operation::difference: return '-';
    case Operation::complement: return '!';
    }
    return '.';
}

EventCase tree_case(const TracedRay& ray, const TraceObject& object, const NodeEvaluated& root) {
    std::vector<std::string> nodes, leaves;
    for (std::size_t i = 0; i < object.nodes.size(); ++i) {
        const TraceNode& node = object.nodes[i];
        Id left = std::max(node.left, 0);
        if (node.operation == Operation::leaf) {
            std::vector<std::string> spans;
            for (const SpanFound& span : spans_of(ray, root.object, Id(i))) spans.push_back(code(span));
            left = Id(leaves.size());
            leaves.push_back(list_code("Spans", spans));
        }
        nodes.push_back(
            fmt::format("{{'{}', {}, {}}}", symbol(node.operation), left, std::max(node.right, 0)));
    }
    return {"2-03-tree", fmt::format("{}, {}, {}", list_code("std::vector<Node>", nodes), root.node,
                                     list_code("std::vector<Spans>", leaves))};
}

} // namespace

std::optional<EventCase> inside_case(const EventPlace& place) {
    const auto index = node_event(place);
    if (!index) return std::nullopt;
    const auto& node = std::get<NodeEvaluated>(place.ray.events[*index]);
    const TraceObject& object = place.trace.objects[std::size_t(node.object)];
    if (object.nodes[std::size_t(node.node)].operation == Operation::leaf)
        return hits_case(spans_after(place.ray, *index));
    return tree_case(place.ray, object, node);
}

} // namespace rayscope::exercises
