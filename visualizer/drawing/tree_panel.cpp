#include "visualizer/drawing/tree_panel.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/text.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace rayscope::drawing {
namespace {

constexpr double line = 1.5; // of the font's size

struct Row {
    int ray = 0, level = 0, parent_row = -1;
};

/// Depth first, without recursion: a trace may be very deep.
std::vector<Row> rows_of(const Trace& trace) {
    std::vector<Row> rows, open{{0, 0, -1}};
    if (trace.rays.empty()) return rows;
    while (!open.empty()) {
        const Row row = open.back();
        open.pop_back();
        const int here = int(rows.size());
        rows.push_back(row);
        const std::vector<int>& children = trace.rays[std::size_t(row.ray)].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            if (*child > row.ray && std::size_t(*child) < trace.rays.size())
                open.push_back({*child, row.level + 1, here});
    }
    return rows;
}

std::string row_text(const Trace& trace, int id) {
    const TracedRay& ray = trace.rays[std::size_t(id)];
    std::string text = fmt::format("{} {}", id, kind_name(ray.start().kind));
    const bool total = ray.start().kind == RayKind::reflected && ray.parent != none &&
                       trace.rays[std::size_t(ray.parent)].find<TotallyReflected>() != nullptr;
    if (total) text += " (total)";
    return text + (is_blocked(ray) ? " ✗ " : " → ") + target_name(trace, ray);
}

/// The rows that are shown, first to last.
struct Shown {
    std::size_t first, last;
};

Shown shown_rows(const std::vector<Row>& rows, int current, std::size_t fit) {
    if (rows.size() <= fit) return {0, rows.size()};
    const auto at = std::ranges::find(rows, current, &Row::ray);
    const std::size_t middle = at == rows.end() ? 0 : std::size_t(at - rows.begin());
    std::size_t first = middle > fit / 2 ? middle - fit / 2 : 0;
    first = std::min(first, rows.size() - fit);
    return {first, first + fit};
}

class TreeDrawing {
public:
    TreeDrawing(Canvas& canvas, const Area& area, const std::vector<Row>& rows, Shown shown, double font)
        : canvas_(canvas), area_(area), rows_(rows), shown_(shown), font_(font) {
        int deepest = 1;
        for (std::size_t i = shown.first; i < shown.last; ++i) deepest = std::max(deepest, rows[i].level);
        indent_ = std::min(font * 1.15, area.width * 0.3 / deepest);
    }

    [[nodiscard]] double x(const Row& row) const { return area_.x + font_ * 0.9 + indent_ * row.level; }
    [[nodiscard]] double y(std::size_t row) const {
        return area_.y + font_ * line * (double(row) - double(shown_.first) + 0.5);
    }

    /// Lines from each parent down to its children, the hidden ones included.
    void guides() {
        const double top = area_.y, bottom = y(shown_.last) - font_ * line / 2;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const Row& row = rows_[i];
            if (row.parent_row < 0 || i < shown_.first || std::size_t(row.parent_row) >= shown_.last)
                continue;
            const double gx = x(rows_[std::size_t(row.parent_row)]) + indent_ * 0.3;
            const bool parent_shown = std::size_t(row.parent_row) >= shown_.first;
            const double from = parent_shown ? y(std::size_t(row.parent_row)) + font_ * 0.65 : top;
            const double to = i < shown_.last ? y(i) : bottom;
            if (gx > area_.right() - font_) continue;
            canvas_.add(Stroke{{{gx, from}, {gx, to}}, guide, 1});
            if (i < shown_.last) canvas_.add(Stroke{{{gx, to}, {x(row) - 2, to}}, guide, 1});
        }
    }

    void row(const Trace& trace, std::size_t i, int current, const std::vector<int>& path) {
        const Row& row = rows_[i];
        const TracedRay& ray = trace.rays[std::size_t(row.ray)];
        const bool here = row.ray == current;
        const bool on_path = std::ranges::binary_search(path, row.ray);
        if (here)
            canvas_.add(
                FilledArea{{area_.x + 2, y(i) - font_ * line / 2, area_.width - 4, font_ * line}, highlight});
        const std::string share = number(weight(ray), 2);
        const double share_x = area_.right() - font_ * 0.8;
        canvas_.add(Text{{share_x, y(i)}, share, font_ * 0.9, quiet_ink, Font::sans, Align::right});
        const double room = share_x - text_width(share, Font::sans, font_ * 0.9) - font_ * 0.6 - x(row);
        const Font font = on_path ? Font::bold : Font::sans;
        canvas_.add(Text{{x(row), y(i)},
                         elided(row_text(trace, row.ray), font, font_, room),
                         font_,
                         ray_text_colour(ray),
                         font});
    }

private:
    static constexpr Rgb guide{0xB4, 0xBA, 0xC2};
    Canvas& canvas_;
    const Area& area_;
    const std::vector<Row>& rows_;
    Shown shown_;
    double font_, indent_;
};

} // namespace

double tree_height(const Trace& trace, double font) {
    return font * (line * double(trace.rays.size()) + 2.6);
}

void draw_tree(Canvas& canvas, const Area& area, const Trace& trace, int current, double font) {
    const std::vector<Row> rows = rows_of(trace);
    const std::string count = std::to_string(rows.size()) + (rows.size() == 1 ? " ray" : " rays");
    const double title_y = area.y + font * 1.2;
    canvas.add(
        Text{{area.x + font * 0.9, title_y}, "Recursion tree: " + count, font * 1.08, ink, Font::bold});
    canvas.add(Text{
        {area.right() - font * 0.8, title_y}, "weight", font * 0.9, quiet_ink, Font::sans, Align::right});

    Area body{area.x, area.y + font * 2.4, area.width, area.height - font * 2.6};
    std::size_t fit = std::size_t(std::max(body.height / (font * line), 1.0));
    const bool cut = rows.size() > fit;
    if (cut) { // a line above and one below tell what is hidden
        body.y += font * line;
        fit = fit > 3 ? fit - 2 : 1;
    }
    const Shown shown = shown_rows(rows, current, fit);
    TreeDrawing drawing(canvas, body, rows, shown, font);
    const std::vector<int> path = path_to(trace, current);
    drawing.guides();
    for (std::size_t i = shown.first; i < shown.last; ++i) drawing.row(trace, i, current, path);
    const auto hidden = [&](std::size_t rays, double row, const char* where) {
        if (rays == 0) return;
        const std::string text = fmt::format("… {} {} {}", rays, rays == 1 ? "ray" : "rays", where);
        canvas.add(
            Text{{area.x + font * 0.9, body.y + font * line * (row + 0.5)}, text, font * 0.92, quiet_ink});
    };
    if (!cut) return;
    hidden(shown.first, -1, "above");
    hidden(rows.size() - shown.last, double(fit), "below");
}

} // namespace rayscope::drawing
