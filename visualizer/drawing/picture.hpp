#pragma once
// A trace as a picture: the view, and around it the recursion tree, the current ray's numbers and its timeline.

#include "visualizer/drawing/layout.hpp"

namespace rayscope::drawing {

struct PictureOptions {
    PictureSize size;
    /// The current ray: its path stands out. none: all rays are drawn alike, and the panels show the first one.
    int ray = none;
};

/// Bytes R, G, B, row by row from the top.
struct Raster {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};

/// Needs no display. The same input gives the same bytes. Throws InputError if the trace has no such ray, or no ray.
[[nodiscard]] Raster draw_picture(const Workbench& bench, const Trace& trace, const PictureOptions& options);

/// A PNG file, complete or not at all.
void write_picture(const Workbench& bench, const Trace& trace, const std::filesystem::path& path,
                   const PictureOptions& options);

} // namespace rayscope::drawing
