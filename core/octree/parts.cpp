#include "core/octree/parts.hpp"

#include "core/stage/test_cost.hpp"

namespace rayscope {

template <Numbers N> void OctreeParts<N>::prepare(std::span<const std::uint32_t> objects, double margin) {
    margin_ = margin;
    brief_.resize(world_.objects.size());
    for (const std::uint32_t id : objects) {
        const Object& object = world_.objects[id];
        Brief& brief = brief_[id];
        brief.cost = float(test_cost_in_leaf(world_, object));
        if (!world_.is_ball(object)) continue;
        const Solid<N>& ball = world_.solids[object.index];
        brief.centre = as<double>(ball.transform.translation());
        brief.radius = double(std::get<Sphere<N>>(ball.shape).radius);
    }
}

template <Numbers N> auto OctreeParts<N>::bounds_of(std::uint32_t object) const -> Box<double> {
    const Brief& brief = brief_[object];
    if (brief.radius < 0) return world_.objects[object].bounds;
    return {brief.centre - Vec3d{brief.radius}, brief.centre + Vec3d{brief.radius}};
}

template <Numbers N> void OctreeParts<N>::share(std::span<const std::uint32_t> objects, const Cell& cell) {
    std::array<Box<double>, 8> boxes;
    for (unsigned child = 0; child < 8; ++child) {
        parts_[child].objects.clear();
        parts_[child].extent = {};
        parts_[child].cost = 0;
        boxes[child] = cell.part(child).box();
        boxes[child].low -= margin_;
        boxes[child].high += margin_;
    }
    for (const std::uint32_t id : objects) {
        const Brief& brief = brief_[id];
        if (brief.radius >= 0) {
            share_ball(brief, id, cell);
            continue;
        }
        const Object& object = world_.objects[id];
        const Box<double> bounds = object.bounds;
        for (unsigned child = 0; child < 8; ++child)
            if (bounds.overlaps(boxes[child]) &&
                has_surface_in(world_, object, as<ScalarOf<N>>(boxes[child]), covers_))
                add(child, id, bounds, double(brief.cost));
    }
    for (unsigned child = 0; child < 8; ++child) {
        Box<double>& extent = parts_[child].extent;
        extent.low -= margin_;
        extent.high += margin_;
        extent = intersected(extent, boxes[child]);
    }
}

template <Numbers N>
void OctreeParts<N>::add(unsigned child, std::uint32_t object, const Box<double>& bounds, double cost) {
    Part& part = parts_[child];
    part.objects.push_back(object);
    part.extent = united(part.extent, bounds);
    part.cost += cost;
}

// cover_of for the eight parts at once: the distances from the centre, squared, add up axis by axis.
template <Numbers N>
void OctreeParts<N>::share_ball(const Brief& ball, std::uint32_t object, const Cell& cell) {
    std::array<std::array<double, 2>, 3> least, most; // squared, of the lower and the upper half
    const double half = cell.edge / 2;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = cell.low[axis] - ball.centre[axis], middle = low + half, high = low + cell.edge;
        const cover::Sizes<double> lower(low - margin_, middle + margin_),
            upper(middle - margin_, high + margin_);
        const auto k = std::size_t(axis);
        least[k] = {lower.least * lower.least, upper.least * upper.least};
        most[k] = {lower.most * lower.most, upper.most * upper.most};
    }
    const Vec3d radius{ball.radius};
    const Box<double> bounds{ball.centre - radius, ball.centre + radius};
    const double limit = ball.radius * ball.radius;
    constexpr double rounding = 16 * epsilon<double>;
    const double inner = limit * (1 - rounding), outer = limit * (1 + rounding);
    for (unsigned child = 0; child < 8; ++child) {
        const std::size_t x = child & 1U, y = child >> 1U & 1U, z = child >> 2U;
        if (least[0][x] + least[1][y] + least[2][z] <= outer && most[0][x] + most[1][y] + most[2][z] >= inner)
            add(child, object, bounds, double(brief_[object].cost));
    }
}

template class OctreeParts<double>;

} // namespace rayscope
