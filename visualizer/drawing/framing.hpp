#pragma once
// Where the picture is taken from: a three-quarter view from the side, never along the eye's own rays.

#include "visualizer/drawing/view.hpp"

namespace rayscope::drawing {

/// The same for every current ray, so that pictures of successive steps can be compared.
[[nodiscard]] View framed(const Trace& trace, const Scene& scene, const Region& region, const Area& area);

} // namespace rayscope::drawing
