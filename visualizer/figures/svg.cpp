#include "visualizer/figures/svg.hpp"

#include "visualizer/page/base64.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rayscope::figures {
namespace {

std::string hexadecimal(Rgb c) { return fmt::format("#{:02X}{:02X}{:02X}", c.red, c.green, c.blue); }

std::string stroke(const Pen& pen) {
    std::string text =
        fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4g}")", hexadecimal(pen.colour), pen.width);
    if (*pen.dash != '\0') text += fmt::format(R"( stroke-dasharray="{}")", pen.dash);
    return text;
}

std::string filling(const Fill& fill) {
    return fmt::format(R"(fill="{}" fill-opacity="{:.3g}")", hexadecimal(fill.colour), fill.opacity);
}

// No "-0.0": the sign of a rounded zero would differ where the number itself hardly does.
std::string rounded(double value) {
    const double tenth = std::round(value * 10) / 10;
    return fmt::format("{:.5g}", tenth == 0 ? 0.0 : tenth);
}
std::string pair(Pixel p) { return rounded(p.x) + " " + rounded(p.y); }

std::string points_of(const std::vector<Pixel>& points) {
    std::string text;
    for (const Pixel& p : points) text += (text.empty() ? "M" : " ") + pair(p);
    return text;
}

Pixel between(Pixel a, Pixel b, double share) {
    return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

} // namespace

void Svg::line(Pixel from, Pixel to, const Pen& pen) { path({from, to}, pen); }

void Svg::path(const std::vector<Pixel>& points, const Pen& pen) {
    body_ += fmt::format("<path d=\"{}\" {} stroke-linejoin=\"round\"/>\n", points_of(points), stroke(pen));
}

void Svg::outline(std::vector<Pixel> points, const Pen& pen) {
    points.push_back(points.front());
    path(points, pen);
}

void Svg::area(const std::vector<Pixel>& points, const Fill& fill) {
    area(std::vector<std::vector<Pixel>>(1, points), fill);
}

void Svg::area(const std::vector<std::vector<Pixel>>& parts, const Fill& fill) {
    std::string text;
    for (const auto& part : parts) text += points_of(part) + "Z";
    body_ += fmt::format("<path d=\"{}\" {}/>\n", text, filling(fill));
}

void Svg::rectangle(const drawing::Area& a, const Fill& fill) {
    body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", rounded(a.x),
                         rounded(a.y), rounded(a.width), rounded(a.height), filling(fill));
}

void Svg::frame(const drawing::Area& a, const Pen& pen) {
    body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", rounded(a.x),
                         rounded(a.y), rounded(a.width), rounded(a.height), stroke(pen));
}

void Svg::circle(Pixel c, double radius, const Pen& pen) {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", rounded(c.x), rounded(c.y),
                         rounded(radius), stroke(pen));
}

void Svg::dot(Pixel c, double radius, Rgb colour) {
    body_ += fmt::format(
        "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"#FFFFFF\" stroke-width=\"1.5\"/>\n",
        rounded(c.x), rounded(c.y), rounded(radius), hexadecimal(colour));
}

void Svg::diamond(Pixel c, double radius, Rgb colour) {
    area({{c.x, c.y - radius}, {c.x + radius, c.y}, {c.x, c.y + radius}, {c.x - radius, c.y}}, {colour});
}

void Svg::arrow(Pixel from, Pixel to, const Pen& pen) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    const double head = std::min(length, 6 + 3 * pen.width);
    line(from, between(to, from, 0.8 * head / length), pen);
    const double x = (to.x - from.x) / length * head, y = (to.y - from.y) / length * head;
    area({to, {to.x - x - y * 0.4, to.y - y + x * 0.4}, {to.x - x + y * 0.4, to.y - y - x * 0.4}},
         {pen.colour});
}

void Svg::heading(Pixel from, Pixel to, const Pen& pen, double share) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    const double half = (6 + 3 * pen.width) / 2 / length;
    const Pixel tip = between(from, to, share + half), foot = between(from, to, share - half);
    const double x = (tip.x - foot.x) * 0.4, y = (tip.y - foot.y) * 0.4;
    area({tip, {foot.x - y, foot.y + x}, {foot.x + y, foot.y - x}}, {pen.colour});
}

void Svg::arc(Pixel centre, double radius, double from, double to, const Pen& pen) {
    std::vector<Pixel> points;
    constexpr int parts = 24;
    for (int i = 0; i <= parts; ++i) {
        const double angle = from + (to - from) * i / parts;
        points.push_back({centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)});
    }
    path(points, pen);
}

void Svg::text(Pixel at, const std::string& words, const Type& type) {
    constexpr const char* anchors[] = {"start", "middle", "end"};
    body_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{:.3g}\" fill=\"{}\"{} text-anchor=\"{}\">{}</text>\n",
        rounded(at.x), rounded(at.y + 0.36 * type.size), type.size, hexadecimal(type.colour),
        type.bold ? " font-weight=\"bold\"" : "", anchors[std::size_t(type.anchor)], in_markup(words));
}

void Svg::image(const drawing::Area& a, const std::vector<std::uint8_t>& png) {
    body_ += fmt::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
        rounded(a.x), rounded(a.y), rounded(a.width), rounded(a.height), page::base64(png));
}

std::string Svg::finish(const std::string& title, const std::string& description) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.5g} {1:.5g}\" role=\"img\">\n"
        "<title>{2}</title>\n<desc>{3}</desc>\n"
        "<style>text{{font-family:\"DejaVu Sans\",Verdana,sans-serif;paint-order:stroke;stroke:#FFFFFF;"
        "stroke-width:4px;stroke-linejoin:round}}</style>\n"
        "<rect width=\"{0:.5g}\" height=\"{1:.5g}\" fill=\"#FFFFFF\"/>\n{4}</svg>\n",
        width_, height_, in_markup(title), in_markup(description), body_);
}

} // namespace rayscope::figures
