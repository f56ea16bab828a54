#pragma once
// Which objects a stage with boxes can't keep in one.

#include "core/boxes/slab_ray.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// The largest of its solids' Transform::distortion().
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] T distortion_of(const World<N>& world, const Object& object) {
    const auto of = [&](std::uint32_t solid) { return world.solids[solid].transform.distortion(); };
    if (world.is_ball(object)) return T(3);
    if (!object.is_compound) return of(object.index);
    T most = T(0);
    for (const CompoundNode& node : world.compounds[object.index].nodes)
        if (node.operation == Operation::leaf) most = maximum(most, of(node.solid));
    return most;
}

/// True for what has no end, or ends so far away that products of its coordinates overflow, and for what a matrix
/// distorts so much that one box margin for it would blow up the boxes of all others.
template <Numbers N> [[nodiscard]] bool stands_apart(const World<N>& world, const Object& object) {
    using T = ScalarOf<N>;
    if (!object.bounds.bounded()) return true;
    constexpr double farthest = std::is_same_v<T, float> ? 0x1p30 : 0x1p300;
    return !(largest_coordinate(object.bounds) < farthest) ||
           !(double(distortion_of(world, object)) <= most_distorted_object);
}

/// Of the objects that do not stand apart: how large they and their distortion are.
struct Reach {
    Box<double> bounds;
    double distortion = 3;

    /// The largest coordinate.
    [[nodiscard]] double size() const { return largest_coordinate(bounds); }
    /// How far rounding may put a crossing beside its object, for rays from this far away: see SlabRay.
    [[nodiscard]] double margin(double origin) const {
        return 64 * epsilon<double> * distortion * (origin + size());
    }
};

/// @param apart, together take up the objects that do and do not stand apart
template <Numbers N>
[[nodiscard]] Reach sort_out(const World<N>& world, std::vector<std::uint32_t>& apart,
                             std::vector<std::uint32_t>& together) {
    Reach reach;
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (stands_apart(world, object)) {
            apart.push_back(id);
            continue;
        }
        together.push_back(id);
        reach.bounds = united(reach.bounds, object.bounds);
        reach.distortion = maximum(reach.distortion, double(distortion_of(world, object)));
    }
    return reach;
}

} // namespace rayscope
