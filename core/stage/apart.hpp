#pragma once
// Which objects a stage with boxes can't keep in one.

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
    const Vec3d size = maximum_of(absolute(object.bounds.low), absolute(object.bounds.high));
    constexpr double farthest = std::is_same_v<T, float> ? 0x1p30 : 0x1p300;
    constexpr T strongest = T(1024);
    return !(largest_component(size) < farthest) || !(distortion_of(world, object) <= strongest);
}

} // namespace rayscope
