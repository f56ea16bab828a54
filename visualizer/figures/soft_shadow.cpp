// Why a lamp's shadow has a soft edge: the rays that ask for points of the lamp, and how many are free along the floor.

#include "visualizer/drawing/ray_path.hpp"

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/sheet.hpp"

#include <string>

namespace rayscope::figures {
namespace {

int free_rays(const Trace& trace) {
    int count = 0;
    for (const int ray : children_of(trace, trace.rays[0], RayKind::shadow))
        count += drawing::is_blocked(trace.rays[std::size_t(ray)]) ? 0 : 1;
    return count;
}

/// Straight down onto the floor, from so little above it that nothing else is met.
Trace onto_floor(const Workbench& bench, const Vec3d& place) {
    return trace_ray(bench, {{place.x, place.y, 0.001}, {0, 0, -1}});
}

/// The floor under the sheet, each piece as bright as the part of the lamp that it sees.
void draw_floor(Svg& svg, const Workbench& bench, const Sheet& sheet, double from, double to) {
    constexpr double piece = 0.04, top = 10, height = 40;
    const int samples = bench.scene.lights.at(0).area.samples;
    struct Part {
        double from, to;
        int seen; ///< 0: nothing, 1: a part, 2: all of the lamp
    };
    std::vector<Part> parts;
    for (int i = 0; from + i * piece < to; ++i) {
        const double at = from + i * piece;
        const int count = free_rays(onto_floor(bench, sheet.origin + sheet.right * (at + piece / 2)));
        const Rgb shade = drawing::mixed(black, {0xFF, 0xEE, 0x99}, double(count) / samples);
        svg.rectangle({sheet.at.x + at * sheet.scale, sheet.at.y + top, piece * sheet.scale + 0.5, height},
                      {shade});
        const int seen = count == 0 ? 0 : count < samples ? 1 : 2;
        if (parts.empty() || parts.back().seen != seen) parts.push_back({at, at, seen});
        parts.back().to = at + piece;
    }
    for (const Part& part : parts) {
        constexpr const char* names[] = {"full shadow", "penumbra", "lit"};
        const double left = sheet.at.x + part.from * sheet.scale, right = sheet.at.x + part.to * sheet.scale,
                     y = sheet.at.y + top + height;
        svg.line({left, sheet.at.y}, {left, y + 8}, {black, 1.5});
        svg.line({right, sheet.at.y}, {right, y + 8}, {black, 1.5});
        const bool half = part.seen == 1; // narrow: its name stands a line below
        if (half) svg.line({(left + right) / 2, y + 6}, {(left + right) / 2, y + 38}, {grey, 1.5});
        svg.text({(left + right) / 2, y + (half ? 52 : 22)}, names[part.seen], {19, black, half});
    }
}

} // namespace

Svg soft_shadow(const Subject& subject) {
    Svg svg(1000, 800);
    const Workbench& bench = subject.bench;
    const SceneLight& lamp = bench.scene.lights.at(0);
    const Trace trace = trace_ray(bench, {{1.54, -0.385, 2}, {0, 0, -1}});
    const auto asked = children_of(trace, trace.rays[0], RayKind::shadow);
    if (asked.empty() || lamp.area.radius <= 0)
        throw InputError(bench.scene.file, {}, "a figure needs a lamp with an area");
    const Vec3d place = trace.rays[std::size_t(asked[0])].start().origin,
                foot{lamp.position.x, lamp.position.y, 0};
    const Sheet sheet{
        foot, normalized(Vec3d{place.x - foot.x, place.y - foot.y, 0}), {0, 0, 1}, {110, 680}, 95};

    svg.line({20, sheet.at.y}, {780, sheet.at.y}, {black, 3});
    const auto point_asked = [&](const TracedRay& ray) {
        const RaySpawned& start = ray.start();
        return sheet(start.origin + normalized(start.direction) * start.reach);
    };
    std::vector<const TracedRay*> open, blocked;
    for (const int ray : asked) {
        const TracedRay& traced = trace.rays[std::size_t(ray)];
        (drawing::is_blocked(traced) ? blocked : open).push_back(&traced);
    }
    for (const TracedRay* ray : blocked) svg.line(sheet(place), point_asked(*ray), {grey, 1.2, "9 9"});
    const Workbench ball = apart(bench.scene, {"orange2"});
    const auto cut = section(sheet, 0, 1.5, [&](const Ray<double>& ray) { return list_of(ball, ray); });
    svg.area(cut, {drawing::mixed(orange, white, 0.5)});
    svg.outline(cut.at(0), {black, 2});
    for (const TracedRay* ray : open) svg.line(sheet(place), point_asked(*ray), {vermilion, 1.2});
    svg.circle(sheet(lamp.position), lamp.area.radius * sheet.scale, {black, 2.5});
    for (const TracedRay* ray : blocked) svg.circle(point_asked(*ray), 4, {black, 1.8});
    for (const TracedRay* ray : open) svg.dot(point_asked(*ray), 5.5, vermilion);
    svg.dot(sheet(place), 8, purple);
    svg.text(sheet(lamp.position, lamp.area.radius * sheet.scale + 16, -30), "lamp",
             {22, black, true, Anchor::start});
    svg.text({sheet.at.x + 3.81 * sheet.scale, sheet.at.y - 0.65 * sheet.scale}, "orange2", {20});
    constexpr double key = 470;
    svg.line({key, 200}, {key + 60, 200}, {vermilion, 2.5});
    svg.dot({key + 66, 200}, 5.5, vermilion);
    svg.text({key + 86, 200},
             std::to_string(open.size()) + " of " + std::to_string(asked.size()) +
                 " rays find their point of the lamp",
             {20, black, false, Anchor::start});
    svg.line({key, 250}, {key + 60, 250}, {grey, 2, "9 9"});
    svg.circle({key + 66, 250}, 4, {black, 1.8});
    svg.text({key + 86, 250}, std::to_string(blocked.size()) + " are stopped by orange2",
             {20, black, false, Anchor::start});
    draw_floor(svg, bench, sheet, -0.9, 7);
    return svg;
}

} // namespace rayscope::figures
