#pragma once
// Which lists of vertices make a flat polygon.

#include "core/math/vec.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rayscope {

/// What is wrong with the outline of a polygon, if anything: fewer than three vertices, all on one line (or an
/// outline that crosses itself and encloses nothing), an extreme size, or a vertex that lies off the plane by more
/// than `flatness` of the polygon's size.
[[nodiscard]] std::optional<std::string> polygon_problem(const std::vector<Vec3d>& vertices, double flatness);

} // namespace rayscope
