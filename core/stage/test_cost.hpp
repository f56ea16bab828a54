#pragma once
// What a tree reckons with where it decides which objects go together.

#include "core/generics/test_costs.hpp"
#include "core/stage/free_triangle.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// What a generic costs on the average, in units of a ball that is tested with seven others.
inline constexpr double generic_cost = 6;

/// The same of an object. Measured.
template <Numbers N> [[nodiscard]] double test_cost(const World<N>& world, const Object& object) {
    constexpr double of_ball = 1, of_box = 1.5;
    constexpr double of_triangle = 1.5; // with others
    if (world.is_ball(object)) return of_ball;
    if (object.is_compound) return generic_cost * double(world.compounds[object.index].nodes.size());
    if (free_triangle(world, object) != nullptr) return of_triangle;
    return of_box * test_costs[world.solids[object.index].shape.index()];
}

/// The same of an object in a leaf of a tree, where sixteen balls are tested in the time of six.
template <Numbers N> [[nodiscard]] double test_cost_in_leaf(const World<N>& world, const Object& object) {
    constexpr double of_ball = 0.375;
    return world.is_ball(object) ? of_ball : test_cost(world, object);
}

} // namespace rayscope
