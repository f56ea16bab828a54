#pragma once
// Which part of the picture is for what.

#include "visualizer/drawing/lanes.hpp"
#include "visualizer/drawing/view.hpp"

namespace rayscope::drawing {

struct PictureSize {
    int width = 1280, height = 720;

    [[nodiscard]] bool valid() const {
        return width >= 480 && height >= 320 && width <= 7680 && height <= 4320;
    }
};

struct Layout {
    double font = 12;  ///< pixels; at least 10, whatever the picture's size
    double pixels = 1; ///< width of a hair line
    Area title, view, legend, timeline, tree, details;
};

/// How many lanes a picture of this size has room for.
[[nodiscard]] std::size_t most_lanes(const PictureSize& size);

[[nodiscard]] Layout layout_of(const PictureSize& size, const Trace& trace, int current, bool ghosts,
                               const Lanes& lanes);

} // namespace rayscope::drawing
