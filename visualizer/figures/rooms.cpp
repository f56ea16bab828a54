// A room of mirrors from above, and a crowd behind its rectangles.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

namespace rayscope::figures {

Svg recursion_level_3(const Subject& subject) {
    Svg svg(1000, 700);
    const Scene& scene = subject.bench.scene;
    const Trace trace = trace_pixel(subject.bench, 600, 235);
    const Sheet sheet{{0, -0.5, 0}, {1, 0, 0}, {0, 0, -1}, {500, 340}, 108};
    for (const char* name : {"ball", "cube"}) {
        const Workbench thing = apart(scene, {name});
        const auto cut =
            section(sheet, -2.9, 2.9, [&](const Ray<double>& ray) { return list_of(thing, ray); });
        svg.area(cut, {orange, 0.5});
        svg.outline(cut.at(0), {black, 2});
    }
    svg.text(sheet({0.5, 0, -0.6}), "ball", {19});
    svg.text(sheet({-0.7, 0, -1.4}), "cube", {19});
    svg.frame({500 - 216, 340 - 324, 432, 648}, {grey, 2});
    for (const double side : {-1.0, 1.0}) {
        const double x = 500 + side * 216;
        svg.line({x, 16}, {x, 664}, {blue, 6});
        for (double y = 28; y < 664; y += 24)
            svg.line({x, y}, {x + side * 14, y + 14}, {blue, 2}); // their backs
        svg.text({x + side * 30, 60}, "mirror", {21, blue, true, side < 0 ? Anchor::end : Anchor::start});
    }
    constexpr const char* levels[] = {"level 0, eye", "level 1", "level 2", "level 3"};
    int ray = 0;
    for (int level = 0;; ++level) {
        const RaySpawned& start = trace.rays[std::size_t(ray)].start();
        const Vec3d from = start.origin, to = end_point(trace, ray, 2), middle = (from + to) / 2.0;
        svg.line(sheet(from), sheet(to), pen_of(start.kind, 4));
        svg.heading(sheet(from), sheet(to), pen_of(start.kind, 4), 0.6);
        svg.dot(sheet(to), 7, purple);
        // Beside the room, where there is space; a thin line leads to the ray.
        const bool right = level == 0 || level == 3;
        constexpr double heights[] = {600, 540, 300, 300};
        const double y = heights[level];
        const Pixel end{right ? 760.0 : 240.0, y};
        svg.line(sheet(middle), end, {grey, 1.5});
        const Anchor anchor = right ? Anchor::start : Anchor::end;
        svg.text({end.x + (right ? 6 : -6), y}, levels[level], {21, level == 0 ? black : blue, true, anchor});
        svg.text({end.x + (right ? 6 : -6), y + 28},
                 "weight " + digits(weight(trace.rays[std::size_t(ray)]), 3), {19, grey, false, anchor});
        const auto next = children_of(trace, trace.rays[std::size_t(ray)], RayKind::reflected);
        if (next.empty() || level == 3) break;
        ray = next.front();
    }
    const Pixel eye = sheet(trace.eye);
    svg.dot(eye, 9, black);
    svg.text({eye.x, eye.y + 28}, "eye", {21, black, true});
    svg.text({500, 686},
             "seen from above; level 2 ends on the floor, under the ball; max_depth = " +
                 std::to_string(trace.max_depth),
             {20});
    return svg;
}

Svg projective_rectangles(const Subject& subject) {
    constexpr int width = 480, height = 360;
    constexpr double scale = 900.0 / width;
    Svg svg(900, 715);
    RenderOptions options;
    options.width = width;
    options.height = height;
    svg.image({0, 0, 900, height * scale}, png_of(render(subject.bench, options).image));
    const ScreenExtents extents = screen_extents(subject.bench, width, height);
    for (const auto& r : extents.rectangles) {
        const drawing::Area area{r.left * scale, r.top * scale, (r.right - r.left) * scale,
                                 (r.bottom - r.top) * scale};
        svg.frame(area, {white, 4});
        svg.frame(area, {black, 1.8});
    }
    svg.text({450, 696},
             std::to_string(extents.rectangles.size()) +
                 " objects, each with its rectangle; the ground has none",
             {20});
    return svg;
}

} // namespace rayscope::figures
