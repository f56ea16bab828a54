#include "visualizer/drawing/legend.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <functional>

namespace rayscope::drawing {
namespace {

struct Entry {
    std::string text;
    Rgb colour;
    enum class Mark : std::uint8_t { line, dashes, arrow, dot, bar } mark = Mark::line;
};

std::vector<Entry> entries_of(const Trace& trace, bool ghosts) {
    std::vector<Entry> entries;
    const auto first = [&](const std::function<bool(const TracedRay&)>& which) {
        const auto found = std::ranges::find_if(trace.rays, which);
        return found == trace.rays.end() ? nullptr : &*found;
    };
    for (const RayKind kind : {RayKind::eye, RayKind::reflected, RayKind::refracted})
        if (const auto* ray = first([&](const TracedRay& r) { return r.start().kind == kind; }))
            entries.push_back({kind_name(kind), ray_colour(*ray)});
    for (const bool blocked : {false, true})
        if (const auto* ray = first([&](const TracedRay& r) {
                return r.start().kind == RayKind::shadow && is_blocked(r) == blocked;
            }))
            entries.push_back(
                {blocked ? "shadow, blocked" : "shadow, light seen", ray_colour(*ray), Entry::Mark::dashes});
    if (first([](const TracedRay& r) { return r.find<BoundaryChosen>() != nullptr; }) != nullptr) {
        entries.push_back({"hit", hit_purple, Entry::Mark::dot});
        entries.push_back({"normal", normal_green, Entry::Mark::arrow});
    }
    if (first([](const TracedRay& r) { return r.find<NodeEvaluated>() != nullptr; }) != nullptr)
        entries.push_back({"inside", lane_colour(0, false), Entry::Mark::bar});
    const auto looked_into = [](const TracedRay& r) {
        const auto* place = r.find<PlaceEntered>();
        return place != nullptr && place->kind != PlaceKind::tile && place->kind != PlaceKind::light_cell;
    };
    if (first(looked_into) != nullptr) entries.push_back({"cell that the ray visits", place_blue});
    if (ghosts) entries.push_back({"pale: other rays", mixed(quiet_ink, sky, 0.6)});
    return entries;
}

void draw_mark(Canvas& canvas, const Entry& entry, double x, double y, double width) {
    const Pixel from{x, y}, to{x + width, y};
    switch (entry.mark) {
    case Entry::Mark::line: canvas.add(Stroke{{from, to}, entry.colour, 3}); break;
    case Entry::Mark::dashes: canvas.add(Stroke{{from, to}, entry.colour, 2.4, true}); break;
    case Entry::Mark::dot: canvas.add(Disc{{x + width / 2, y}, width * 0.2, entry.colour}); break;
    case Entry::Mark::bar:
        canvas.add(FilledArea{{x, y - width * 0.14, width, width * 0.28}, entry.colour});
        break;
    case Entry::Mark::arrow:
        canvas.add(Stroke{{from, {to.x - width * 0.3, y}}, entry.colour, 2});
        canvas.add(
            FilledPolygon{{to, {to.x - width * 0.4, y - width * 0.2}, {to.x - width * 0.4, y + width * 0.2}},
                          entry.colour});
        break;
    }
}

} // namespace

double draw_legend(Canvas* canvas, double x, double y, double width, const Trace& trace, bool ghosts,
                   double font) {
    const double row = font * 1.6, mark = font * 1.9, gap = font * 1.3;
    double at = x, line = y;
    for (const Entry& entry : entries_of(trace, ghosts)) {
        const double size = mark + font * 0.5 + text_width(entry.text, Font::sans, font);
        if (at > x && at + size > x + width) {
            at = x;
            line += row;
        }
        if (canvas != nullptr) {
            draw_mark(*canvas, entry, at, line + row / 2, mark);
            canvas->add(Text{{at + mark + font * 0.5, line + row / 2}, entry.text, font, ink});
        }
        at += size + gap;
    }
    return line + row - y;
}

} // namespace rayscope::drawing
