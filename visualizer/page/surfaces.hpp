#pragma once
// What is drawn around the rays.

#include "visualizer/page/tessellate.hpp"

namespace rayscope::page {

struct Surface {
    std::string name;
    Colour colour{0.7}; ///< sRGB, 0 … 1
    bool clear = false; ///< lets light through
    bool flat = false;  ///< a half space: its square is drawn as a checkerboard …
    Vec3d u{0}, v{0};   ///< … along these, one square long
    Triangles triangles;
};

struct Surroundings {
    Ball shown;
    std::vector<Surface> surfaces; ///< those that rays end on first
    std::size_t left_out = 0;      ///< objects that the page has no room for
};

/// Hits, by the weight of their rays, and the bounded objects that they lie on; of objects what fits into `room` bytes.
[[nodiscard]] Surroundings surroundings_of(const Workbench& bench, const Trace& trace, std::size_t room);

/// Bytes that a surface takes in the page.
[[nodiscard]] std::size_t written_size(const Surface& surface);

} // namespace rayscope::page
