// What a ray does at a surface: mirrored, bent, mirrored in total.

#include "visualizer/figures/rays.hpp"

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::figures {

const BoundaryChosen& hit_of(const Trace& trace, int ray) {
    const auto* hit = trace.rays.at(std::size_t(ray)).find<BoundaryChosen>();
    if (hit == nullptr) throw InputError(trace.source.scene, {}, "a figure's ray hits nothing");
    return *hit;
}

int child_of(const Trace& trace, int ray, RayKind kind) {
    const auto children = children_of(trace, trace.rays.at(std::size_t(ray)), kind);
    if (children.empty()) throw InputError(trace.source.scene, {}, "a figure's ray has no such child");
    return children.front();
}

Vec3d end_point(const Trace& trace, int ray, double open_length) {
    const TracedRay& traced = trace.rays.at(std::size_t(ray));
    const auto* hit = traced.find<BoundaryChosen>();
    const RaySpawned& start = traced.start();
    return hit != nullptr ? hit->point : start.origin + normalized(start.direction) * open_length;
}

Pen pen_of(RayKind kind, double width) {
    switch (kind) {
    case RayKind::reflected: return {blue, width, "12 5"};
    case RayKind::refracted: return {vermilion, width};
    case RayKind::shadow: return {orange, width, "4 5"};
    case RayKind::eye: break;
    }
    return {black, width};
}

void draw_angle(Svg& svg, const Sheet& sheet, const Vec3d& at, const Vec3d& from, const Vec3d& to,
                double radius, const std::string& words, Rgb colour, double beyond) {
    double a = sheet.angle(from), b = sheet.angle(to);
    if (b - a > M_PI) b -= 2 * M_PI;
    if (a - b > M_PI) a -= 2 * M_PI;
    svg.arc(sheet(at), radius, a, b, {colour, 2.5});
    const double middle = (a + b) / 2;
    svg.text(sheet(at, (radius + beyond) * std::cos(middle), -(radius + beyond) * std::sin(middle)), words,
             {21, colour, true});
}

namespace {

/// A surface that is flat on the sheet, at the height y of the page.
void draw_ground(Svg& svg, double y, double height, Rgb colour) {
    svg.rectangle({0, y, 1000, height}, {colour, 0.3});
    svg.line({0, y}, {1000, y}, {black, 2.5});
}

} // namespace

Svg mirrored_direction(const Subject& subject) {
    Svg svg(1000, 520);
    const Trace trace = trace_ray(subject.bench, {{0, 0, 3}, {0, 0.6, -0.8}});
    const BoundaryChosen& hit = hit_of(trace, 0);
    const int mirrored = child_of(trace, 0, RayKind::reflected);
    const Sheet sheet{hit.point, {0, 1, 0}, {0, 0, 1}, {500, 420}, 190};
    draw_ground(svg, 420, 100, sky_blue);
    const Vec3d in = trace.rays[0].start().direction,
                out = trace.rays[std::size_t(mirrored)].start().direction;
    const Vec3d p = hit.point, n = hit.normal;
    svg.line(sheet(p), sheet(p + n * 2.05), {grey, 1.5, "3 5"});
    svg.arrow(sheet(p), sheet(p + n), {green, 4});
    svg.text(sheet(p + n, 22, 6), "n", {26, green, true});
    const Vec3d from = p - in * 1.9, to = p + out * 1.9;
    svg.line(sheet(from), sheet(p), {black, 4});
    svg.heading(sheet(from), sheet(p), {black, 4});
    svg.arrow(sheet(p), sheet(to), pen_of(RayKind::reflected, 4));
    svg.text(sheet(p - in, -30, 14), "d", {26, black, true});
    svg.text(sheet(p + out, 30, 14), "l", {26, blue, true});
    const auto* reflected = trace.rays[0].find<Reflected>();
    const std::string theta = "θ = " + in_degrees(reflected->theta);
    draw_angle(svg, sheet, p, -in, n, 120, "θ", black, 22);
    draw_angle(svg, sheet, p, n, out, 120, "θ", blue, 22);
    svg.dot(sheet(p), 8, purple);
    svg.text(sheet(p, 0, 36), "r(t₀) = (0, " + digits(p.y) + ", " + digits(p.z) + ")", {21});
    svg.text({985, 445}, "mirror, z = 1", {19, black, false, Anchor::end});
    svg.text({500, 500}, "l = d − 2 (d · n) n,  both angles " + theta, {21, black, true});
    svg.text({16, 30}, "d = (" + digits(in.x) + ", " + digits(in.y) + ", " + digits(in.z) + ")",
             {20, black, false, Anchor::start});
    svg.text({984, 30}, "l = (" + digits(out.x) + ", " + digits(out.y) + ", " + digits(out.z) + ")",
             {20, blue, false, Anchor::end});
    return svg;
}

Svg two_media(const Subject& subject) {
    Svg svg(1000, 560);
    const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {250, 280}, 190};
    draw_ground(svg, 280, 280, sky_blue);
    svg.line({500, 0}, {500, 560}, {white, 14});
    struct Case {
        double x;
        Ray<double> ray;
        const char* title;
    };
    const double s = std::sqrt(0.5);
    double water = 0; // its speed of light
    for (const Case& shown : {Case{250, {{-1.2, 1.2, 0}, {s, -s, 0}}, "into the slower medium"},
                              Case{750, {{-0.75, -1.2, 0}, {0.53, 0.848, 0}}, "into the faster medium"}}) {
        const Trace trace = trace_ray(subject.bench, shown.ray);
        const BoundaryChosen& hit = hit_of(trace, 0);
        const auto* bent = trace.rays[0].find<Refracted>();
        const RefractionCard card = refraction_card(trace, 0).value();
        water = std::min(card.speed_from, card.speed_to);
        const Sheet here{hit.point, sheet.right, sheet.up, {shown.x, 280}, 190};
        const Vec3d p = hit.point, n = hit.facing, in = normalized(trace.rays[0].start().direction);
        svg.line(here(p - n * 1.2), here(p + n * 1.2), {grey, 1.5, "3 5"});
        svg.line(here(p), here(p + in * 1.25), {grey, 2, "3 6"});
        svg.arrow(here(p), here(p + n * 0.75), {green, 3.5});
        svg.text(here(p + n * 0.75, -20, 0), "n", {24, green, true});
        svg.line(here(p - in * 1.3), here(p), {black, 4});
        svg.heading(here(p - in * 1.3), here(p), {black, 4});
        svg.arrow(here(p), here(p + bent->direction * 1.3), pen_of(RayKind::refracted, 4));
        draw_angle(svg, here, p, -in, n, 86, "", black, 0);
        draw_angle(svg, here, p, -n, bent->direction, 86, "", vermilion, 0);
        const double above = n.y > 0 ? -58 : 58; // where the ray comes from
        svg.text({shown.x - 84, 280 + above}, "θ₁ = " + in_degrees(bent->theta_from),
                 {21, black, true, Anchor::end});
        svg.text({shown.x + 84, 280 - above}, "θ₂ = " + in_degrees(bent->theta_to),
                 {21, vermilion, true, Anchor::start});
        svg.dot(here(p), 7, purple);
        svg.text({shown.x, 22}, shown.title, {21, black, true});
    }
    svg.text({14, 250}, "air, c = 1", {19, black, false, Anchor::start});
    svg.text({14, 310}, "water, c = " + digits(water), {19, black, false, Anchor::start});
    svg.text({985, 310}, "water", {19, black, false, Anchor::end});
    svg.text({985, 250}, "air", {19, black, false, Anchor::end});
    return svg;
}

Svg critical_angle(const Subject& subject) {
    Svg svg(1000, 480);
    const double level = 220;
    draw_ground(svg, level, 260, sky_blue);
    struct Case {
        double x, degrees;
        const char* title;
    };
    const Trace upright = trace_ray(subject.bench, {{0, -1, 0}, {0, 1, 0}});
    const double critical = upright.rays[0].find<Refracted>()->critical * 180 / M_PI;
    for (const Case& shown :
         {Case{170, 35, "below"}, Case{490, std::floor(critical * 100) / 100, "at the limit"},
          Case{830, 60, "above"}}) {
        const double angle = shown.degrees * M_PI / 180;
        const Vec3d d{std::sin(angle), std::cos(angle), 0};
        const Trace trace = trace_ray(subject.bench, {Vec3d{0, 0, 0} - d, d});
        const BoundaryChosen& hit = hit_of(trace, 0);
        const Sheet here{hit.point, {1, 0, 0}, {0, 1, 0}, {shown.x, level}, 185};
        const Vec3d p = hit.point, n = hit.facing;
        const auto* bent = trace.rays[0].find<Refracted>();
        const double above = bent != nullptr ? 0.9 : 0.62; // below the words
        svg.line(here(p - Vec3d{0, 0.9, 0}), here(p + Vec3d{0, above, 0}), {grey, 1.5, "3 5"});
        svg.line(here(p - d), here(p), {black, 4});
        svg.heading(here(p - d), here(p), {black, 4}, 0.35);
        draw_angle(svg, here, p, -d, n, 80, "", black, 0);
        svg.text(here(p, 0, 192), "θ₁ = " + in_degrees(angle, 2), {21, black, true});
        if (bent != nullptr) {
            svg.arrow(here(p), here(p + bent->direction * 0.86), pen_of(RayKind::refracted, 4));
            svg.text({shown.x, 26}, shown.title, {21, black, true});
            svg.text({shown.x + 46, level - 172 + 6}, "θ₂ = " + in_degrees(bent->theta_to, 1),
                     {21, vermilion, true, Anchor::start});
        } else {
            const int mirrored = child_of(trace, 0, RayKind::reflected);
            svg.arrow(here(p), here(p + trace.rays[std::size_t(mirrored)].start().direction * 0.86),
                      pen_of(RayKind::reflected, 4));
            svg.text({shown.x, 26}, shown.title, {21, black, true});
            svg.text({shown.x, level - 172 + 6 + 30}, "no θ₂: all is mirrored", {20, blue, true});
        }
        svg.dot(here(p), 7, purple);
    }
    svg.text({14, level - 20}, "air", {19, black, false, Anchor::start});
    svg.text({14, level + 22}, "water", {19, black, false, Anchor::start});
    svg.text({500, 458}, "critical angle: arcsin(c₁ / c₂) = " + digits(critical, 2) + "°", {21, black, true});
    return svg;
}

Svg prism_path(const Subject& subject) {
    Svg svg(1000, 600);
    const Trace trace = trace_pixel(subject.bench, 240, 240);
    const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {560, 260}, 190};
    const std::size_t prism = drawn_called(subject.bench.scene, "prism");
    const auto cut =
        section(sheet, -1.2, 1.2, [&](const Ray<double>& ray) { return list_of(subject.bench, ray, prism); });
    svg.area(cut, {sky_blue, 0.35});
    svg.outline(cut.at(0), {black, 2.5});
    svg.rectangle({0, 260 + 190 * 1.6, 1000, 36}, {orange, 0.3});
    svg.line({0, 260 + 190 * 1.6}, {1000, 260 + 190 * 1.6}, {black, 2});

    const int inside = child_of(trace, 0, RayKind::refracted),
              turned = child_of(trace, inside, RayKind::reflected),
              out = child_of(trace, turned, RayKind::refracted);
    const Vec3d start = hit_of(trace, 0).point - normalized(trace.rays[0].start().direction) * 1.7;
    svg.line(sheet(start), sheet(hit_of(trace, 0).point), {black, 4});
    svg.heading(sheet(start), sheet(hit_of(trace, 0).point), {black, 4});
    for (const int ray : {inside, turned, out}) {
        const Pen pen = pen_of(trace.rays[std::size_t(ray)].start().kind, 4);
        const Vec3d from = trace.rays[std::size_t(ray)].start().origin, to = end_point(trace, ray, 1);
        svg.line(sheet(from), sheet(to), pen);
        svg.heading(sheet(from), sheet(to), pen);
    }
    const BoundaryChosen& mirror = hit_of(trace, inside);
    const auto* total = trace.rays[std::size_t(inside)].find<TotallyReflected>();
    const Vec3d n = mirror.facing;
    svg.line(sheet(mirror.point), sheet(mirror.point + n * 0.8), {green, 2.5, "5 5"});
    const Vec3d d = trace.rays[std::size_t(inside)].start().direction;
    draw_angle(svg, sheet, mirror.point, -d, n, 70, "θ₁", black, 24);
    for (const int ray : {0, inside, turned}) svg.dot(sheet(hit_of(trace, ray).point), 7, purple);
    svg.text(sheet(start, 60, -26), "eye's ray", {21, black, true});
    svg.text({640, 120}, "mirrored in total:", {21, black, true, Anchor::start});
    svg.text({640, 150},
             "θ₁ = " + in_degrees(total->theta_from) + ", critical " + in_degrees(total->critical),
             {21, black, false, Anchor::start});
    svg.text({640, 180}, "it carries " + digits(largest_component(total->coefficient)) + " of the light",
             {21, black, false, Anchor::start});
    svg.line(sheet(mirror.point, 8, -8), {634, 160}, {grey, 1.5});
    svg.text(sheet(hit_of(trace, turned).point, 26, 40), "leaves, hardly bent",
             {21, vermilion, true, Anchor::start});
    svg.text(sheet({-0.5, -0.86, 0}), "glass, n = 1.5", {20});
    svg.text({14, 578}, "floor", {19, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
