#include "core/trace/check_trace.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rayscope {
namespace {

template <typename... Args> [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
    throw std::runtime_error(fmt::format(text, std::forward<Args>(args)...));
}

void check_nodes(const TraceObject& object, std::size_t index) {
    if (object.nodes.empty()) fail("objects[{}].nodes: expected at least one node", index);
    for (std::size_t i = 0; i < object.nodes.size(); ++i) {
        const TraceNode& node = object.nodes[i];
        const auto is_before = [&](Id id) { return id >= 0 && std::size_t(id) < i; };
        const bool leaf = node.operation == Operation::leaf, one = node.operation == Operation::complement;
        const bool left = leaf ? node.left == none : is_before(node.left);
        const bool right = leaf || one ? node.right == none : is_before(node.right);
        const bool generic = leaf == (node.generic != none);
        if (!left || !right || !generic)
            fail("objects[{}].nodes[{}]: a leaf has a generic and no operands, a complement one operand "
                 "(left), the "
                 "other operations two, and operands come before their node",
                 index, i);
    }
}

void check_links(const Trace& trace) {
    if (trace.rays.empty()) fail("rays: expected at least one ray");
    if (trace.rays.front().parent != none) fail("rays[0].parent: expected -1");
    std::size_t links = 0;
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        int previous = int(i);
        for (const int child : ray.children) {
            if (child <= previous || std::size_t(child) >= trace.rays.size())
                fail("rays[{}].children: expected ascending indices of later rays, found {}", i, child);
            if (trace.rays[std::size_t(child)].parent != int(i))
                fail("rays[{}].parent: ray {} names it as its child, but it names {}", child, i,
                     trace.rays[std::size_t(child)].parent);
            previous = child;
        }
        links += ray.children.size();
    }
    // Each link was to a ray of its own, so the count tells whether a ray is missing.
    if (links + 1 != trace.rays.size()) fail("rays: a ray is not among its parent's children");
}

void check_events(const Trace& trace, const TracedRay& ray, std::size_t index) {
    if (ray.events.empty() || !std::holds_alternative<RaySpawned>(ray.events.front()))
        fail("rays[{}].events: expected to begin with ray_spawned", index);
    for (std::size_t i = 0; i < ray.events.size(); ++i) {
        if (i > 0 && std::holds_alternative<RaySpawned>(ray.events[i]))
            fail("rays[{}].events[{}]: a ray starts only once", index, i);
        const auto* node = std::get_if<NodeEvaluated>(&ray.events[i]);
        if (node == nullptr) continue;
        const std::size_t nodes = trace.objects[std::size_t(node->object)].nodes.size();
        if (node->node < 0 || std::size_t(node->node) >= nodes)
            fail("rays[{}].events[{}].node: expected an index below {}, found {}", index, i, nodes,
                 node->node);
        if (node->count < 0)
            fail("rays[{}].events[{}].count: expected 0 or more, found {}", index, i, node->count);
    }
    const RaySpawned& start = ray.start();
    if ((start.kind == RayKind::shadow) != (start.light != none))
        fail("rays[{}].events[0].light: shadow rays ask for a light, and only they", index);
}

} // namespace

std::size_t target_size(const Trace& trace, Target target) {
    switch (target) {
    case Target::nothing: return 0;
    case Target::object:
    case Target::object_or_none: return trace.objects.size();
    case Target::light:
    case Target::light_or_none: return trace.lights.size();
    case Target::medium_or_none: return trace.media.size();
    case Target::generic_or_none: return trace.generics.size();
    }
    return 0;
}

bool allows_none(Target target) { return target != Target::object && target != Target::light; }

void check_trace(const Trace& trace) {
    for (std::size_t i = 0; i < trace.objects.size(); ++i) check_nodes(trace.objects[i], i);
    check_links(trace);
    for (std::size_t i = 0; i < trace.rays.size(); ++i) check_events(trace, trace.rays[i], i);
}

} // namespace rayscope
