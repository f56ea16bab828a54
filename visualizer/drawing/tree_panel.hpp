#pragma once
// The recursion tree as text beside the picture.

#include "visualizer/drawing/canvas.hpp"

namespace rayscope::drawing {

/// When the tree is longer than the area, the part around the current ray is shown, and how many rows are not.
void draw_tree(Canvas& canvas, const Area& area, const Trace& trace, int current, double font);

/// How high the whole tree would be.
[[nodiscard]] double tree_height(const Trace& trace, double font);

} // namespace rayscope::drawing
