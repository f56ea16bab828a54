// What a light sees: its window, cut into cells, and how many objects each lists.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace rayscope::figures {
namespace {

using CellNumber = std::pair<int, int>; ///< column, row

/// How a light looks at the scene: the axes along which the core cuts its window.
struct LightsEye {
    Vec3d position, forward, right, down;

    LightsEye(const Vec3d& from, const Vec3d& to) : position(from), forward(normalized(to - from)) {
        const Vec3d size = absolute(forward);
        Vec3d beside{0};
        beside[size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2)] = 1;
        right = normalized(cross(forward, beside));
        down = cross(forward, right);
    }
    /// Slopes, for a point before the light.
    [[nodiscard]] Vec3d slopes(const Vec3d& point) const {
        const Vec3d v = point - position;
        return Vec3d{dot(v, right), dot(v, down), dot(v, forward)} / dot(v, forward);
    }
};

/// A shadow ray's start as its light sees it, and the cell that it was looked for in.
struct Asked {
    Vec3d seen;
    CellNumber cell;
    int held;
};

std::vector<Asked> asked_by(const Trace& trace, const LightsEye& view) {
    std::vector<Asked> list;
    for (const TracedRay& ray : trace.rays) {
        if (ray.start().kind != RayKind::shadow) continue;
        if (trace.lights[std::size_t(ray.start().light)].position != view.position) continue;
        const auto* place = ray.find<PlaceEntered>();
        if (place == nullptr || place->kind != PlaceKind::light_cell) continue;
        list.push_back({view.slopes(ray.start().origin),
                        {int(std::lround(place->low.x)), int(std::lround(place->low.y))},
                        place->held});
    }
    return list;
}

/// Where the first cell begins, and how wide one is: between what was seen in neighbouring ones.
struct Scale {
    double first = 0, step = 1;
    int cells = 1;
    [[nodiscard]] double at(double cell) const { return first + step * cell; }
    /// But for the width of a line.
    [[nodiscard]] bool holds(double slope, int cell) const {
        const double place = (slope - first) / step - cell;
        return place > -0.05 && place < 1.05;
    }
};

template <typename Cell, typename Slope>
Scale scale_of(const std::vector<Asked>& all, const Cell& cell, const Slope& slope) {
    int last = 0;
    for (const Asked& asked : all) last = std::max(last, cell(asked));
    const auto border = [&](int number) { // between the cells number − 1 and number
        double below = -infinity<double>, above = infinity<double>;
        for (const Asked& asked : all)
            if (cell(asked) < number)
                below = std::max(below, slope(asked));
            else
                above = std::min(above, slope(asked));
        return (below + above) / 2;
    };
    const double step = (border(last) - border(1)) / (last - 1);
    return {border(1) - step, step, last + 1};
}

} // namespace

Svg light_cells(const Subject& subject) {
    const Workbench& bench = subject.bench;
    const auto stages = make_stages(bench, stage_choice("light"));
    Box<double> box{Vec3d{infinity<double>}, Vec3d{-infinity<double>}}; // of what has an end
    for (const Object& object : bench.world.objects)
        if (object.bounds.bounded()) box = united(box, object.bounds);
    const LightsEye view(bench.world.lights.at(0).position, (box.low + box.high) / 2.0);

    // Shadow rays from all over the ground ask for every cell.
    std::vector<Asked> all;
    std::map<CellNumber, int> held;
    constexpr int rows = 160;
    constexpr double half = 14;
    const double ground = hit_of(trace_ray(bench, {{half, half, box.high.z}, {0, 0, -1}}), 0).point.z;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < rows; ++j) {
            const double x = ((i + 0.5) / rows * 2 - 1) * half, y = ((j + 0.5) / rows * 2 - 1) * half;
            // Below the objects; and from above, where one of them stands on the ground.
            for (const double z : {ground + 1e-3, box.high.z + 1})
                for (const Asked& asked :
                     asked_by(trace_ray(bench, *stages, {{x, y, z}, {0, 0, -1}}), view)) {
                    all.push_back(asked);
                    held[asked.cell] = asked.held;
                }
        }
    const Scale columns = scale_of(
                    all, [](const Asked& a) { return a.cell.first; },
                    [](const Asked& a) { return a.seen.x; }),
                lines = scale_of(
                    all, [](const Asked& a) { return a.cell.second; },
                    [](const Asked& a) { return a.seen.y; });

    if (held.size() != std::size_t(columns.cells) * std::size_t(lines.cells))
        throw InputError("light_cells", {}, "not every cell of the light was asked for");
    for (const Asked& asked : all)
        if (!columns.holds(asked.seen.x, asked.cell.first) || !lines.holds(asked.seen.y, asked.cell.second))
            throw InputError("light_cells", {}, "the light's cells do not stand as the figure draws them");

    // The image from the light: it sees no shadow of its own.
    const double half_width = 1.04 * std::max(-columns.first, columns.at(columns.cells)),
                 half_height = 1.04 * std::max(-lines.first, lines.at(lines.cells));
    constexpr int width = 400;
    const int height = int(std::lround(width * half_height / half_width));
    constexpr double wide = 580;
    const double scale = wide / (2 * half_width), bottom = 2 * half_height * scale;
    Scene scene = bench.scene;
    scene.camera.eye = view.position;
    scene.camera.look_at = view.position + view.forward;
    scene.camera.up = -view.down;
    scene.camera.field_of_view = 2 * std::atan(half_height) * 180 / std::numbers::pi;
    RenderOptions options;
    options.width = width;
    options.height = height;
    Svg svg(1000, bottom);
    svg.image({0, 0, wide, bottom}, png_of(render(make_workbench(scene), options).image));
    svg.rectangle({0, 0, wide, bottom}, {white, 0.4});
    const auto page = [&](double x, double y) {
        return Pixel{(x + half_width) * scale, (y + half_height) * scale};
    };
    for (int i = 0; i <= columns.cells; ++i)
        svg.line(page(columns.at(i), lines.first), page(columns.at(i), lines.at(lines.cells)), {grey, 1.2});
    for (int i = 0; i <= lines.cells; ++i)
        svg.line(page(columns.first, lines.at(i)), page(columns.at(columns.cells), lines.at(i)), {grey, 1.2});
    for (const auto& [cell, count] : held)
        if (count > 0)
            svg.text(page(columns.at(cell.first + 0.5), lines.at(cell.second + 0.5)), std::to_string(count),
                     {19});

    // One shadow ray. The light sees it as a point.
    const Trace trace = trace_pixel(bench, *stages, 330, 250);
    const Asked one = asked_by(trace, view).at(0);
    const Pixel corner = page(columns.at(one.cell.first), lines.at(one.cell.second)),
                across = page(columns.at(one.cell.first + 1), lines.at(one.cell.second + 1));
    const drawing::Area marked{corner.x, corner.y, across.x - corner.x, across.y - corner.y};
    svg.frame(marked, {white, 8});
    svg.frame(marked, {vermilion, 5});
    svg.dot(page(one.seen.x, one.seen.y), 8, purple);
    std::string names;
    int read = 0;
    for (const TracedRay& ray : trace.rays)
        for (const Event& event : ray.events)
            if (const auto* entry = std::get_if<PlaceEntered>(&event);
                entry != nullptr && entry->kind == PlaceKind::entry && ray.start().kind == RayKind::shadow) {
                names += (read++ > 0 ? ", " : "") + trace.objects[std::size_t(entry->object)].name;
            }
    const auto say = [&](double y, const std::string& words, bool bold = false) {
        svg.text({650, y}, words, {20, black, bold, Anchor::start});
    };
    const auto number = [](std::size_t count) { return std::to_string(count); };
    say(40, "What the lamp sees", true);
    say(72, number(std::size_t(columns.cells)) + " × " + number(std::size_t(lines.cells)) +
                " cells; the number:");
    say(100, "objects in the cell’s list");
    say(128, "(no number: none)");
    svg.dot({625, 190}, 8, purple);
    say(190, "a shadow ray: the lamp");
    say(218, "sees it as one point");
    svg.frame({613, 263, 24, 24}, {vermilion, 5});
    say(275, "the cell that it comes");
    say(303, "through: " + number(std::size_t(one.held)) + " of " + number(bench.world.objects.size()) +
                 " objects");
    say(331, "asked: " + names);
    say(393, "The lamp sees no shadow of");
    say(421, "its own; those here are the");
    say(449, "other lamp’s.");
    say(511, "All objects lie before the");
    say(539, "lamp: one window will do,");
    say(567, "in place of a cube’s six sides.");
    return svg;
}

} // namespace rayscope::figures
