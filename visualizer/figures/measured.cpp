// What accuracy costs, as it was measured: error against time, from the table that is kept with the lesson.

#include "visualizer/drawing/placed_names.hpp"
#include "visualizer/figures/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace rayscope::figures {
namespace {

constexpr drawing::Area cost_plot{110, 84, 860, 446};
constexpr double letter_size = 18;

struct Measured {
    std::string name, scalar;
    bool textbook = false, on_front = false;
    double milliseconds = 0, error = 0;
};

double number_in(const std::map<std::string, std::string>& row, const std::string& column) {
    const std::string& text = row.at(column);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// The first row is the scene's own configuration; each other one is named by what differs from it.
std::vector<Measured> read_cost(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<std::string> columns;
    std::vector<std::map<std::string, std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::map<std::string, std::string> row;
        std::size_t i = 0;
        for (std::string cell; std::getline(cells, cell, ','); ++i)
            if (rows.empty() && columns.size() == i && line.starts_with("scalar"))
                columns.push_back(cell);
            else if (i < columns.size())
                row[columns[i]] = cell;
        if (!row.empty()) rows.push_back(row);
    }
    std::vector<Measured> all;
    for (const auto& row : rows) {
        const auto& own = rows.front();
        if (row.size() != columns.size())
            throw InputError(path.string(), {}, "expected a cell for each column in each line");
        std::string name = row.at("scalar") + (row.at("method") == "textbook" ? " textbook" : " stable");
        if (row.at("max_depth") != own.at("max_depth")) name = "depth " + row.at("max_depth");
        if (row.at("min_weight") != own.at("min_weight")) name = "weight " + row.at("min_weight");
        if (all.empty()) name = "the scene's own";
        all.push_back({name, row.at("scalar"), row.at("method") == "textbook", row.at("on_front") == "1",
                       1000 * number_in(row, "seconds_median"), number_in(row, "relative_rmse")});
    }
    if (all.empty()) throw InputError(path.string(), {}, "expected a table of measurements");
    return all;
}

struct LogScale {
    double low, high; // decades
    [[nodiscard]] double share(double value) const { return (std::log10(value) - low) / (high - low); }
};

Rgb scalar_colour(const std::string& scalar) {
    if (scalar.empty()) return black;
    if (scalar == "float") return blue;
    if (scalar == "double") return vermilion;
    return scalar == "long double" ? green : Rgb{0xAA, 0x3C, 0x84};
}

void draw_mark(Svg& svg, Pixel p, const std::string& scalar, bool textbook) {
    if (textbook)
        svg.diamond(p, 9, scalar_colour(scalar));
    else
        svg.dot(p, 8, scalar_colour(scalar));
}

} // namespace

Svg error_against_time(const Subject& subject) {
    Svg svg(1000, 620);
    std::vector<Measured> all = read_cost(subject.chapters / "07_accuracy" / "cost.csv");
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::pair(std::lround(a.error * 100), -a.milliseconds) <
               std::pair(std::lround(b.error * 100), -b.milliseconds);
    });
    LogScale time{1e9, -1e9}, error{std::log10(0.02), std::log10(0.5)};
    for (const Measured& point : all) {
        time.low = std::min(time.low, std::log10(point.milliseconds) - 0.1);
        time.high = std::max(time.high, std::log10(point.milliseconds) + 0.25);
    }
    const auto at = [&](double milliseconds, double wrong) {
        return Pixel{cost_plot.x + cost_plot.width * time.share(milliseconds),
                     cost_plot.bottom() - cost_plot.height * error.share(wrong)};
    };
    for (const double tick : {0.02, 0.05, 0.1, 0.2, 0.5}) {
        const double y = at(1, tick).y;
        svg.line({cost_plot.x, y}, {cost_plot.right(), y}, {pale, 1.2});
        svg.text({cost_plot.x - 12, y}, fmt::format("{:g}", tick), {letter_size, black, false, Anchor::end});
    }
    for (const double tick : {5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
        const double x = at(tick, 1).x;
        if (x < cost_plot.x || x > cost_plot.right()) continue;
        svg.line({x, cost_plot.bottom()}, {x, cost_plot.bottom() + 8}, {black, 2});
        svg.text({x, cost_plot.bottom() + 26}, fmt::format("{:g}", tick), {letter_size});
    }
    svg.line({cost_plot.x, cost_plot.bottom()}, {cost_plot.right(), cost_plot.bottom()}, {black, 2});
    svg.line({cost_plot.x, cost_plot.y}, {cost_plot.x, cost_plot.bottom()}, {black, 2});
    svg.text({20, 34}, "relative error of the image", {20, black, true, Anchor::start});
    svg.text({cost_plot.x + cost_plot.width / 2, cost_plot.bottom() + 60},
             "processor time of the image in ms", {20, black, true});
    std::vector<Pixel> front, marks;
    for (const Measured& point : all) {
        marks.push_back(at(point.milliseconds, point.error));
        if (point.on_front) front.push_back(marks.back());
    }
    std::sort(front.begin(), front.end(), [](Pixel a, Pixel b) { return a.x < b.x; });
    svg.path(front, {black, 2.5});
    std::vector<drawing::NamedMark> groups;
    std::vector<Type> types;
    bool some_are_mixed = false;
    for (std::size_t i = 0; i < all.size();) { // marks over each other share a name
        std::string name = all[i].name;
        Type type{letter_size, scalar_colour(all[i].scalar), all[i].on_front};
        std::size_t next = i + 1;
        for (; next < all.size() && std::abs(marks[next].x - marks[i].x) < 12 &&
               std::abs(marks[next].y - marks[i].y) < 6;
             ++next) {
            name += ", " + all[next].name;
            type.bold = type.bold && all[next].on_front;
            if (all[next].scalar != all[i].scalar) {
                type.colour = black;
                some_are_mixed = true;
            }
        }
        groups.push_back({marks[i], name, type.bold ? drawing::Font::bold : drawing::Font::sans, type.size});
        types.push_back(type);
        i = next;
    }
    const drawing::Area room{cost_plot.x + 4, cost_plot.y, cost_plot.width + 20, cost_plot.height - 4};
    const auto names = drawing::place_names(groups, marks, front, room);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i]) throw InputError("figures", {}, "no place for " + groups[i].name);
        if (!names[i]->lead.empty()) svg.path(names[i]->lead, {grey, 1.2});
    }
    for (std::size_t i = 0; i < all.size(); ++i) draw_mark(svg, marks[i], all[i].scalar, all[i].textbook);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const drawing::Area& area = names[i]->area;
        svg.text({area.x + area.width / 2, area.y + area.height / 2}, groups[i].name, types[i]);
    }
    draw_mark(svg, {430, 34}, "double", false);
    svg.text({446, 34}, "stable", {letter_size, black, false, Anchor::start});
    draw_mark(svg, {540, 34}, "double", true);
    svg.text({556, 34}, "textbook", {letter_size, black, false, Anchor::start});
    svg.text({424, 58}, some_are_mixed ? "orange: double, black: several" : "orange: double",
             {letter_size, black, false, Anchor::start});
    svg.line({680, 34}, {720, 34}, {black, 2.5});
    svg.text({730, 34}, "front: no other is", {letter_size, black, true, Anchor::start});
    svg.text({730, 58}, "quicker and better", {letter_size, black, true, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
