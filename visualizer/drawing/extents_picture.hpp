#pragma once
// Projective extents over the image that they are extents of.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

/// The rectangle of each object and the tiles that list any. Small images are enlarged, those of more than 4096 pixels made
/// smaller.
[[nodiscard]] Raster draw_extents(const ScreenExtents& extents, const Image& image, const std::string& title);

} // namespace rayscope::drawing
