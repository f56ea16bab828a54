// What a perspective does to a box that reaches behind the eye.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/sheet.hpp"

#include <array>

namespace rayscope::figures {
namespace {

const Box<double> the_box{{1, 1, -4}, {2, 2, 1}};

/// The box alone, before an eye in the origin that looks along −z.
Workbench box_beside_the_eye() {
    Scene scene;
    scene.materials.emplace_back();
    SceneGeneric box;
    box.name = "box";
    box.shape = Cube<double>{};
    box.material = 0;
    for (int axis = 0; axis < 3; ++axis) {
        box.matrix[axis][axis] = (the_box.high[axis] - the_box.low[axis]) / 2;
        box.matrix[3][axis] = (the_box.high[axis] + the_box.low[axis]) / 2;
    }
    scene.generics.push_back(std::move(box));
    scene.drawn.push_back({false, 0});
    scene.camera.eye = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    scene.camera.field_of_view = 90;
    return make_workbench(std::move(scene));
}

struct Bar {
    double from, to; ///< slopes
    Pen pen;
    std::string words;
};

} // namespace

Svg near_plane_trap(const Subject& /*subject*/) {
    Svg svg(1000, 936);
    // From above: −z, where the eye looks, is up on the page.
    const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {440, 500}, 110};
    const auto at = [&](double x, double z, double dx = 0, double dy = 0) {
        return sheet(Vec3d{x, 0, z}, dx, dy);
    };
    const auto part = [&](double from, double to) {
        return std::vector<Pixel>{at(the_box.low.x, from), at(the_box.high.x, from), at(the_box.high.x, to),
                                  at(the_box.low.x, to)};
    };
    svg.area(part(the_box.low.z, 0), {sky_blue, 0.55});
    svg.area(part(0, the_box.high.z), {orange, 0.45});
    svg.outline(part(the_box.low.z, the_box.high.z), {black, 2.5});
    svg.line(at(-3.8, 0), at(4.9, 0), {grey, 1.5, "3 5"});
    svg.text(at(4.95, 0, 0, -16), "before the eye", {19, grey, false, Anchor::end});
    svg.text(at(4.95, 0, 0, 18), "behind it", {19, grey, false, Anchor::end});
    // The screen, at distance 1: there a slope is a length.
    svg.line(at(-3.8, -1), at(4.9, -1), {black, 3});
    for (int slope = -3; slope <= 4; ++slope) {
        svg.line(at(slope, -1, 0, -6), at(slope, -1, 0, 6), {black, 2});
        const bool beside_box = slope == 1 || slope == 2; // whose sides pass there
        if (slope != 0)
            svg.text(at(slope, -1, beside_box ? (slope == 1 ? -12 : 12) : 0, 22), digits(slope),
                     {18, beside_box ? black : grey});
    }
    svg.text(at(-3.8, -1, 0, -20), "screen, z = −1", {20, black, true, Anchor::start});
    for (const double x : {the_box.low.x, the_box.high.x}) {
        const double front = x / -the_box.low.z, rear = x / -the_box.high.z;
        svg.line(at(0, 0), at(x, the_box.low.z), {blue, 2});
        svg.line(at(x, the_box.high.z), at(rear, -1), {vermilion, 2, "9 6"});
        svg.dot(at(front, -1), 7, blue);
        svg.dot(at(rear, -1), 8, vermilion);
        svg.dot(at(x, the_box.low.z), 6, blue);
        svg.dot(at(x, the_box.high.z), 6, vermilion);
    }
    const Workbench bench = box_beside_the_eye();
    const Vec3d inside{1.5, 1.5, -1};
    const List seen = list_of(bench, {{0, 0, 0}, inside});
    svg.dot(at(inside.x, inside.z), 8, green);
    svg.text(at(inside.x, inside.z, 0, -24), "seen", {20, green, true});
    svg.text(at(1.34, -3.5), "box", {22, black, true});
    svg.text(at(2.1, the_box.high.z), "corners at z = 1", {20, vermilion, true, Anchor::start});
    svg.text(at(2.1, the_box.low.z), "corners at z = −4", {20, blue, true, Anchor::start});
    svg.dot(at(0, 0), 10, black);
    svg.text(at(0, 0, -16, 24), "eye", {22, black, true, Anchor::end});
    svg.text(at(-3.8, -3.9), "Seen from above.", {20, black, true, Anchor::start});
    svg.text(at(-3.8, -3.6), "The eye looks up the page.", {20, black, false, Anchor::start});

    // The same slopes again, as bars.
    const double near = 0.1;
    const std::array bars{Bar{the_box.high.x / -the_box.high.z,
                              the_box.high.x / -the_box.low.z,
                              {vermilion, 12},
                              "all corners projected"},
                          Bar{the_box.low.x / -the_box.low.z,
                              the_box.high.x / near,
                              {green, 12},
                              "clipped at z = −" + digits(near) + " first"}};
    double y = 690;
    svg.line(at(inside.x, inside.z, 0, 10), {at(inside.x, 0).x, y + 122}, {green, 2, "2 5"});
    for (const Bar& bar : bars) {
        const bool beyond = bar.to > 4.6;
        const Pixel from{at(bar.from, 0).x, y}, to{at(beyond ? 4.6 : bar.to, 0).x, y};
        if (beyond)
            svg.arrow(from, to, {bar.pen.colour, 8});
        else
            svg.line(from, to, bar.pen);
        for (const Pixel& end : {from, to})
            if (!beyond || end.x == from.x) svg.line({end.x, y - 14}, {end.x, y + 14}, {black, 2.5});
        svg.text({beyond ? at(inside.x, 0).x + 14 : from.x, y - 30}, bar.words,
                 {20, bar.pen.colour, true, Anchor::start});
        svg.text({from.x, y + 32}, digits(bar.from), {19});
        svg.text({to.x, y + 32}, digits(bar.to), {19});
        y += 108;
    }
    const bool found = !seen.empty() && seen.front().second > 0;
    const ScreenExtents screen = screen_extents(bench);
    const auto& rectangle = screen.rectangles.at(0);
    const bool everywhere = rectangle.left <= 0 && rectangle.right >= screen.width;
    svg.text(
        {500, 880},
        std::string("The ray of slope ") + digits(inside.x / -inside.z) +
            (found ? " meets the box, outside of the first bar: there it would be cut off." : " misses."),
        {20});
    svg.text({500, 912}, everywhere ? "rayscope’s own rectangle for this box is the whole screen." : "",
             {20});
    return svg;
}

} // namespace rayscope::figures
