// World and object space: the moved ray and the moved normal.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"

namespace rayscope::figures {
namespace {

/// The scene's first generic, untransformed.
Workbench in_object_space(const Scene& scene) {
    Scene changed = scene;
    changed.generics.at(0).matrix = Mat4d{1};
    return make_workbench(std::move(changed));
}

void draw_cut(Svg& svg, const Sheet& sheet, const Workbench& bench, Rgb colour) {
    const auto cut = section(sheet, -1.1, 1.1, [&](const Ray<double>& ray) { return list_of(bench, ray); });
    svg.area(cut, {colour, 0.35});
    svg.outline(cut.at(0), {black, 2.5});
}

/// Two lines of axes and their names.
void draw_axes(Svg& svg, const Sheet& sheet, double left, double right, double low, double high) {
    svg.arrow(sheet({left, 0, 0}), sheet({right, 0, 0}), {grey, 1.5});
    svg.arrow(sheet({0, low, 0}), sheet({0, high, 0}), {grey, 1.5});
    svg.text(sheet({right, 0, 0}, -4, 18), "x", {19, grey});
    svg.text(sheet({0, high, 0}, 18, 4), "y", {19, grey});
}

void draw_marks(Svg& svg, const Sheet& sheet, const Ray<double>& ray, const List& list, double last) {
    svg.arrow(sheet(ray.origin), sheet(ray.at(last)), {black, 3.5});
    const auto beside_axis = [&](const Vec3d& point) { // not on the line of y
        return sheet(point, std::abs(point.x) * sheet.scale < 1 ? -13 : 0, 22);
    };
    for (int t = 1; t < last; ++t) {
        const Pixel p = sheet(ray.at(t));
        svg.line({p.x, p.y - 8}, {p.x, p.y + 8}, {black, 2});
        svg.text(beside_axis(ray.at(t)), digits(t), {18, grey});
    }
    svg.dot(sheet(ray.origin), 7, black);
    svg.text(beside_axis(ray.origin), "0", {18, grey});
    for (const double t : {list.at(0).first, list.at(0).second}) {
        svg.dot(sheet(ray.at(t)), 7, vermilion);
        svg.text(sheet(ray.at(t), 0, -44), "t = " + digits(t), {20, vermilion, true});
    }
}

} // namespace

Svg inverse_ray(const Subject& subject) {
    Svg svg(1000, 450);
    const Workbench object = in_object_space(subject.bench.scene);
    const Ray<double> ray{{0, 0.6, 0}, {1, 0, 0}};
    const Transform<double> transform(subject.bench.scene.generics.at(0).matrix);
    const Ray<double> moved = transform.to_object(ray);
    const Sheet world{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {40, 240}, 76};
    const Sheet own{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {800, 240}, 100};
    draw_axes(svg, world, -0.3, 7, -1.5, 1.9);
    draw_cut(svg, world, subject.bench, sky_blue);
    draw_marks(svg, world, ray, list_of(subject.bench, ray), 6.9);
    draw_axes(svg, own, -2.1, 1.9, -1.14, 1.45);
    draw_cut(svg, own, object, orange);
    draw_marks(svg, own, moved, list_of(object, moved), 6.9);
    svg.text({300, 26}, "world: the ray and M(sphere)", {22, black, true});
    svg.text({770, 26}, "object space: M⁻¹ ray, the sphere", {22, black, true});
    svg.text({300, 395}, "e = (0, 0.6, 0), d = (1, 0, 0)", {20});
    svg.text({770, 395},
             "e′ = (" + digits(moved.origin.x) + ", " + digits(moved.origin.y) + ", 0), d′ = (" +
                 digits(moved.direction.x) + ", 0, 0)",
             {20});
    svg.text({500, 432}, "the same t in both", {22, vermilion, true});
    return svg;
}

Svg normals_inverse_transpose(const Subject& subject) {
    Svg svg(1000, 470);
    const Workbench object = in_object_space(subject.bench.scene);
    const Transform<double> transform(subject.bench.scene.generics.at(0).matrix);
    const Mat4d& matrix = subject.bench.scene.generics.at(0).matrix;
    const Vec3d p{-0.8, 0.6, 0}, n = p, tangent{0.6, 0.8, 0};
    const auto through_m = [&](const Vec3d& v) { return Vec3d(matrix * glm::dvec4(v, 0.0)); };
    const Vec3d there = Vec3d(matrix * glm::dvec4(p, 1.0));
    const Sheet own{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {215, 270}, 120};
    const Sheet world{{4, 0, 0}, {1, 0, 0}, {0, 1, 0}, {715, 270}, 120};
    draw_cut(svg, own, object, orange);
    Sheet cut = world;
    cut.origin.x = 0;
    cut.at.x = world.at.x - 4 * world.scale;
    draw_cut(svg, cut, subject.bench, sky_blue);
    const auto draw = [&](const Sheet& sheet, const Vec3d& at, const Vec3d& along, const Vec3d& normal,
                          double sign) {
        const Vec3d v = normalized(along) * 0.85, u = normalized(normal) * 0.9;
        svg.line(sheet(at - v), sheet(at + v), {grey, 2.5, "7 5"});
        svg.arrow(sheet(at), sheet(at + u), {green, 4.5});
        // The small square of a right angle.
        const Vec3d a = normalized(along) * (0.14 * sign), b = normalized(normal) * 0.14;
        svg.path({sheet(at + a), sheet(at + a + b), sheet(at + b)}, {green, 2});
        svg.dot(sheet(at), 6, black);
    };
    const Vec3d right = transform.normal_to_world(n), wrong = normalized(through_m(n)),
                moved = through_m(tangent);
    svg.arrow(world(there), world(there + wrong * 0.9), {vermilion, 4.5, "10 5"});
    draw(own, p, tangent, n, 1);
    draw(world, there, moved, right, 1);
    svg.text(own(p + n * 0.9, -16, -18), "n", {26, green, true});
    svg.text(own(p + tangent * 0.85, 16, -16), "v", {24, grey, true});
    svg.text(world(there + right * 0.9, 0, -20), "M⁻ᵀ n", {24, green, true});
    svg.text(world(there + wrong * 0.9, -12, 26), "M n", {24, vermilion, true});
    svg.text(world(there + normalized(moved) * 0.85, 34, -14), "M v", {24, grey, true});
    svg.text({215, 26}, "object space", {22, black, true});
    svg.text({715, 26}, "world", {22, black, true});
    svg.text({215, 440}, "n · v = " + digits(dot(n, tangent)), {21});
    svg.text({700, 440},
             "(M n) · (M v) = " + digits(dot(through_m(n), moved)) +
                 ",  (M⁻ᵀ n) · (M v) = " + digits(dot(right, moved)),
             {21});
    return svg;
}

} // namespace rayscope::figures
