#pragma once
// From surfaces, strokes and panels to pixels.

#include "visualizer/drawing/canvas.hpp"
#include "visualizer/drawing/mesh.hpp"
#include "visualizer/drawing/picture.hpp"
#include "visualizer/drawing/surface_paint.hpp"

namespace rayscope::drawing {

/// Drawn at twice the size and averaged: everything is smooth, the translucent surfaces too.
[[nodiscard]] Raster rasterize(const PictureSize& size, const View& view, const PaintedSurfaces& surfaces,
                               const Mesh& strokes, const Canvas& canvas, double pixels);

} // namespace rayscope::drawing
