#include "tests/figures/svg_marks.hpp"

#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace rayscope::figures {
namespace {

using drawing::Area;

/// As many units of the letters' size: DejaVu's tallest letters and its deepest.
constexpr double tall = 0.76, deep = 0.24;

std::string attribute(const std::string& element, const std::string& name) {
    const std::string opening = " " + name + "=\"";
    const std::size_t at = element.find(opening);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + opening.size();
    return element.substr(begin, element.find('"', begin) - begin);
}

double number(const std::string& element, const std::string& name) {
    return std::stod(attribute(element, name));
}

std::string unmarked(std::string words) {
    const std::pair<const char*, const char*> marks[] = {
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
    for (const auto& [mark, character] : marks)
        for (std::size_t at; (at = words.find(mark)) != std::string::npos;)
            words.replace(at, std::string(mark).size(), character);
    return words;
}

PlacedText placed(const std::string& element, const std::string& words, std::size_t order) {
    const double size = number(element, "font-size");
    const bool bold = attribute(element, "font-weight") == "bold";
    const double width = drawing::text_width(words, bold ? drawing::Font::bold : drawing::Font::sans, size);
    const std::string anchor = attribute(element, "text-anchor");
    const double before = anchor == "start" ? 0 : (anchor == "end" ? width : width / 2);
    return {words,
            size,
            order,
            {number(element, "x") - before, number(element, "y") - tall * size, width, (tall + deep) * size}};
}

void add_lines(std::vector<DrawnLine>& lines, const std::string& element, std::size_t order) {
    std::string path = attribute(element, "d");
    if (path.empty() || attribute(element, "stroke").empty()) return;
    path.front() = ' '; // "M": each figure's stroke is one line of points
    std::istringstream numbers(path);
    drawing::Pixel last, next;
    for (bool first = true; numbers >> next.x >> next.y; first = false, last = next)
        if (!first) lines.push_back({last, next, order});
}

void add_cover(std::vector<Cover>& covers, const std::string& element, std::size_t order) {
    const std::string opacity = attribute(element, "fill-opacity");
    if (attribute(element, "fill") == "none" || (!opacity.empty() && opacity != "1")) return;
    if (element.starts_with("<circle ")) {
        const double half = number(element, "r") * std::sqrt(0.5);
        covers.push_back(
            {{number(element, "cx") - half, number(element, "cy") - half, 2 * half, 2 * half}, order});
    } else {
        covers.push_back({{number(element, "x"), number(element, "y"), number(element, "width"),
                           number(element, "height")},
                          order});
    }
}

} // namespace

SvgMarks marks_of(const std::string& svg) {
    static const std::regex text(R"((<text [^>]*>)([^<]*)</text>)");
    SvgMarks marks;
    std::istringstream box(attribute(svg, "viewBox"));
    box >> marks.page.x >> marks.page.y >> marks.page.width >> marks.page.height;
    std::istringstream lines(svg);
    std::size_t order = 0;
    for (std::string line; std::getline(lines, line); ++order) { // an element is a line
        std::smatch found;
        if (line.starts_with("<text ") && std::regex_search(line, found, text))
            marks.texts.push_back(placed(found[1], unmarked(found[2]), order));
        else if (line.starts_with("<path "))
            add_lines(marks.lines, line, order);
        else if (line.starts_with("<circle ") || line.starts_with("<image ") || line.starts_with("<rect x="))
            add_cover(marks.covers, line, order);
    }
    return marks;
}

bool is_covered(const SvgMarks& marks, const Area& area, std::size_t after, std::size_t before) {
    return std::any_of(marks.covers.begin(), marks.covers.end(), [&](const Cover& cover) {
        return cover.order > after && cover.order < before && cover.area.contains(area);
    });
}

Area shrunk(const Area& area, double by) {
    return {area.x + by, area.y + by, std::max(0.0, area.width - 2 * by),
            std::max(0.0, area.height - 2 * by)};
}

} // namespace rayscope::figures
