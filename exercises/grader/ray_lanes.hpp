#pragma once
// Where the line of a ray is inside each object, as bars: those of the right run and those of the student's.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::exercises {

/// SVG: a lane for each object of either run, and in it a bar for each span. Empty where the line meets nothing.
/// @param yours may be nullptr
[[nodiscard]] std::string drawn_lanes(const Trace& right, const Trace* yours);

} // namespace rayscope::exercises
