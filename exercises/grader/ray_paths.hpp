#pragma once
// The way of a ray and of those that follow it, drawn in a plane: that of the right run and that of the student's.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::exercises {

/// SVG, seen across the plane in which the rays first turn. Shadow rays are left out.
/// @param yours may be nullptr
[[nodiscard]] std::string drawn_paths(const Trace& right, const Trace* yours);

} // namespace rayscope::exercises
