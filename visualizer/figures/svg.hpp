#pragma once
// A figure as an SVG file: lines and text as vectors, so that print and projector show them sharply.

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/view.hpp"

#include <string>
#include <vector>

namespace rayscope::figures {

using drawing::Pixel;
using drawing::Rgb;

inline constexpr Rgb black{0x22, 0x22, 0x22}, grey{0x66, 0x66, 0x66}, pale{0xDD, 0xE1, 0xE8},
    white{0xFF, 0xFF, 0xFF};
inline constexpr Rgb orange{0xE6, 0x9F, 0x00}, sky_blue{0x56, 0xB4, 0xE9}, green{0x00, 0x9E, 0x73},
    blue{0x00, 0x72, 0xB2}, vermilion{0xD5, 0x5E, 0x00}, purple{0xCC, 0x79, 0xA7};

struct Pen {
    Rgb colour = black;
    double width = 2;
    const char* dash = ""; ///< as SVG's stroke-dasharray; empty: a solid line
};
struct Fill {
    Rgb colour = pale;
    double opacity = 1;
};
enum class Anchor : std::uint8_t { start, middle, end };
struct Type {
    double size = 20;
    Rgb colour = black;
    bool bold = false;
    Anchor anchor = Anchor::middle;
};

/// Later shapes lie over earlier ones. Sizes are in the figure's own units: 1000 of them are as wide as a page's text.
class Svg {
public:
    Svg(double width, double height) : width_(width), height_(height) {}

    void line(Pixel from, Pixel to, const Pen& pen);
    void path(const std::vector<Pixel>& points, const Pen& pen);
    /// The same, closed.
    void outline(std::vector<Pixel> points, const Pen& pen);
    void area(const std::vector<Pixel>& points, const Fill& fill);
    void area(const std::vector<std::vector<Pixel>>& parts, const Fill& fill);
    void rectangle(const drawing::Area& area, const Fill& fill);
    void frame(const drawing::Area& area, const Pen& pen);
    void circle(Pixel centre, double radius, const Pen& pen);
    void dot(Pixel centre, double radius, Rgb colour);
    void diamond(Pixel centre, double radius, Rgb colour);
    void arrow(Pixel from, Pixel to, const Pen& pen);
    /// A head in the middle of a line.
    void heading(Pixel from, Pixel to, const Pen& pen, double share = 0.5);
    /// Part of a circle; angles in radians, counted from the right towards the top.
    void arc(Pixel centre, double radius, double from, double to, const Pen& pen);
    /// `at` is on the middle of the line of text. What lies under the letters is kept from them by a light rim.
    void text(Pixel at, const std::string& words, const Type& type = {});
    void image(const drawing::Area& area, const std::vector<std::uint8_t>& png);

    /// With the title and the description that a screen reader says.
    [[nodiscard]] std::string finish(const std::string& title, const std::string& description) const;

private:
    double width_, height_;
    std::string body_;
};

} // namespace rayscope::figures
