#pragma once
// The numbers of the current ray, and the sample's colour.

#include "visualizer/drawing/canvas.hpp"

namespace rayscope::drawing {

/// One line of the panel: what it is, its value, and a colour to show, if it is one.
struct Detail {
    std::string name, value;
    std::optional<Colour> swatch;
};

/// The most telling first: where there is little room, the last are left out.
[[nodiscard]] std::vector<Detail> details_of(const Trace& trace, int ray);

[[nodiscard]] double details_height(std::size_t lines, double font);

void draw_details(Canvas& canvas, const Area& area, const Trace& trace, int ray, double font);

} // namespace rayscope::drawing
