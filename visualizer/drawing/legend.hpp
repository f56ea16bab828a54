#pragma once
// What the lines and marks of a picture mean: only those that occur in it.

#include "visualizer/drawing/canvas.hpp"

namespace rayscope::drawing {

/// Draws from left to right in as many rows as are needed, and returns their height. Without a canvas it only
/// measures.
double draw_legend(Canvas* canvas, double x, double y, double width, const Trace& trace, bool ghosts,
                   double font);

} // namespace rayscope::drawing
