#pragma once
// What an SVG figure holds, as areas of its page: texts with the room that they take, and lines.

#include "visualizer/drawing/view.hpp"

#include <string>
#include <vector>

namespace rayscope::figures {

struct PlacedText {
    std::string words;
    double size = 0;
    std::size_t order = 0; ///< what is drawn later has a higher one
    drawing::Area area;    ///< from the top of the tall letters to the bottom of the deep ones
};

struct DrawnLine {
    drawing::Pixel from, to;
    std::size_t order = 0;
};

/// What hides all that was drawn before it: a rectangle, a picture, the square within a disc.
struct Cover {
    drawing::Area area;
    std::size_t order = 0;
};

struct SvgMarks {
    drawing::Area page;
    std::vector<PlacedText> texts;
    std::vector<DrawnLine> lines; ///< each straight piece of each stroke
    std::vector<Cover> covers;    ///< without the page's own white
};

/// Widths are those of DejaVu Sans, the font that the figures name first.
[[nodiscard]] SvgMarks marks_of(const std::string& svg);

/// Whether an area was covered as a whole between two steps of the drawing.
[[nodiscard]] bool is_covered(const SvgMarks& marks, const drawing::Area& area, std::size_t after,
                              std::size_t before);

/// Smaller by so much on each side.
[[nodiscard]] drawing::Area shrunk(const drawing::Area& area, double by);

} // namespace rayscope::figures
