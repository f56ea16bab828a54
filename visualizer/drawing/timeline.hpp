#pragma once
// The strip below the view: the inside intervals of the current ray along its t.

#include "visualizer/drawing/canvas.hpp"
#include "visualizer/drawing/lanes.hpp"

namespace rayscope::drawing {

/// The part of t that is shown.
struct Window {
    double low = 0, high = 1;
};

/// From 0, unless everything happens far from there; up to a little beyond the hit and the intervals near it.
[[nodiscard]] Window timeline_window(const Lanes& lanes, const TracedRay& ray);

/// How high the strip is for so many lanes.
[[nodiscard]] double timeline_height(std::size_t lanes, double font);

void draw_timeline(Canvas& canvas, const Area& area, const Lanes& lanes, const Trace& trace, int ray,
                   double font);

} // namespace rayscope::drawing
