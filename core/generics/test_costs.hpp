#pragma once
// What it costs to ask a generic.

#include "core/generics/generic.hpp"

#include <array>

namespace rayscope {

/// A line's test of a generic, by its index, in tests of a box: bench/accuracy_cost.cpp has the times.
inline constexpr std::array<double, generic_kinds> test_costs{2, 1, 4, 5, 3, 20, 6, 4, 5, 20};

} // namespace rayscope
