#pragma once
// What a tree reckons with where it decides which objects go together.

#include "core/stage/free_triangle.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// Measured: what it costs to test a generic by itself, in units of a ball that is tested with seven others.
inline constexpr double generic_cost = 6;

/// The same of an object.
template <Numbers N> [[nodiscard]] double test_cost(const World<N>& world, const Object& object) {
    constexpr double of_ball = 1, of_triangle = 1.5; // of eight
    if (world.is_ball(object)) return of_ball;
    if (!object.is_compound) return free_triangle(world, object) != nullptr ? of_triangle : generic_cost;
    return generic_cost * double(world.compounds[object.index].nodes.size());
}

} // namespace rayscope
