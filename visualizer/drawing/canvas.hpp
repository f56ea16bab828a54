#pragma once
// Flat drawing in pixels, y down: panels and labels are lists of shapes, painted in order.

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/view.hpp"

#include <string>
#include <variant>
#include <vector>

namespace rayscope::drawing {

enum class Font : std::uint8_t { sans, bold, mono };
enum class Align : std::uint8_t { left, centre, right };

struct FilledArea {
    Area area;
    Rgb colour;
    double opacity = 1;
};
struct Stroke {
    std::vector<Pixel> points;
    Rgb colour;
    double width = 1;
    bool dashed = false;
};
struct FilledPolygon {
    std::vector<Pixel> points;
    Rgb colour;
};
struct Disc {
    Pixel centre;
    double radius = 1;
    Rgb colour;
};
struct Text {
    Pixel at; ///< x by its alignment, y the middle of the line
    std::string text;
    double size = 12;
    Rgb colour;
    Font font = Font::sans;
    Align align = Align::left;
};

/// Pixels as they are, stretched over the area.
struct Bitmap {
    Area area;
    int width = 0, height = 0;
    std::vector<Rgb> pixels; ///< row by row from the top left
};

using Shape = std::variant<FilledArea, Stroke, FilledPolygon, Disc, Text, Bitmap>;

struct Canvas {
    std::vector<Shape> shapes;

    template <typename T> void add(T shape) { shapes.emplace_back(std::move(shape)); }
};

} // namespace rayscope::drawing
