#pragma once
// What a tree reckons with where it decides which objects go together.

#include "core/stage/free_triangle.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// What it costs to test an object, in units of a ball that is tested with seven others.
template <Numbers N> [[nodiscard]] double test_cost(const World<N>& world, const Object& object) {
    // Measured.
    constexpr double of_ball = 1, of_triangle = 1.5, of_generic = 6;
    if (world.is_ball(object)) return of_ball;
    if (!object.is_compound) return free_triangle(world, object) != nullptr ? of_triangle : of_generic;
    return of_generic * double(world.compounds[object.index].nodes.size());
}

} // namespace rayscope
