#include "core/octree/why_not_cell.hpp"

namespace rayscope {
namespace {

/// Between the two planes of a box across one axis: the box without end in the others.
BoxSpan<double> between_planes(const SlabRay<double>& slabs, Box<double> box, int axis) {
    for (int other = 0; other < 3; ++other)
        if (other != axis) {
            box.low[other] = -infinity<double>;
            box.high[other] = infinity<double>;
        }
    return slabs.span(box);
}

} // namespace

std::optional<WhyNotCell> why_not_cell(const Octree<double>& octree, const Ray<double>& ray, double reach,
                                       std::uint32_t wanted) {
    using Why = WhyNotCell::Reason;
    const auto way = octree.way_to(wanted);
    if (!way) return std::nullopt;
    const SlabRay<double> slabs = octree.slabs(ray);
    const OctreeRay meeting(slabs);
    WhyNotCell why;
    const Cell cell = way->empty() ? octree.whole() : way->back().cell.part(way->back().child);
    why.box = cell.box();
    why.level = int(way->size());
    for (int axis = 0; axis < 3; ++axis)
        why.between[std::size_t(axis)] = between_planes(slabs, why.box, axis);
    why.inside = slabs.span(why.box);
    if (why.inside.enter > why.inside.exit) {
        why.reason = Why::box_missed;
        return why;
    }
    if (why.inside.exit < 0) {
        why.reason = Why::behind;
        return why;
    }
    std::array<double, 8> enters{};
    for (std::size_t level = 0; level < way->size(); ++level) {
        const auto& step = (*way)[level];
        const unsigned part = 1U << step.child;
        if ((meeting.meet(*step.node, step.cell, infinity<double>, enters) & part) == 0) {
            why.reason = Why::contents_missed;
            why.level = int(level) + 1;
            return why;
        }
        if (enters[step.child] > reach) {
            why.reason = Why::beyond_reach;
            why.level = int(level) + 1;
            return why;
        }
    }
    return why;
}

} // namespace rayscope
