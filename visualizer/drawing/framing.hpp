#pragma once
// Where the picture is taken from: a three-quarter view from the side, never along the eye's own rays.

#include "visualizer/drawing/view.hpp"

namespace rayscope::drawing {

/// The direction is the same for every current ray, so that pictures of successive steps can be compared.
/// @param chosen a ray whose path must be in the picture, or none
[[nodiscard]] View framed(const Trace& trace, const Scene& scene, const Region& region, const Area& area,
                          int chosen);

} // namespace rayscope::drawing
