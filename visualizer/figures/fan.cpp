// A fan of colours: one ray up to a prism, and one for each wavelength behind its face.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>

namespace rayscope::figures {

Svg dispersion_path(const Subject& subject) {
    Svg svg(1000, 560);
    constexpr int x = 192, y = 240;
    const Trace trace = trace_pixel(subject.bench, x, y);
    const Vec3d level{0, 0, hit_of(trace, 0).point.z}, right = normalized(Vec3d{5.8, 3.9, 0});
    const Sheet sheet{level, right, {-right.y, right.x, 0}, {190, 300}, 80};
    const auto cut = [&](const char* name) {
        const std::size_t i = drawn_called(subject.bench.scene, name);
        return section(sheet, -3, 3, [&](const Ray<double>& ray) { return list_of(subject.bench, ray, i); });
    };
    for (const auto& part : cut("prism")) {
        svg.area(part, {sky_blue, 0.3});
        svg.outline(part, {black, 2.5});
    }
    struct End {
        Pixel at;
        const TracedRay* ray;
        bool slit;
    };
    std::vector<End> ends;
    const Vec3d entry = hit_of(trace, 0).point,
                start = entry - normalized(trace.rays[0].start().direction) * 1.6;
    svg.line(sheet(start), sheet(entry), {black, 4});
    svg.heading(sheet(start), sheet(entry), {black, 4});
    for (const int inside : children_of(trace, trace.rays[0], RayKind::refracted)) {
        const TracedRay& ray = trace.rays[std::size_t(inside)];
        svg.line(sheet(entry), sheet(end_point(trace, inside, 1)), {drawing::ray_colour(ray), 1.8});
        for (const int out : children_of(trace, ray, RayKind::refracted)) {
            const auto* hit = trace.rays[std::size_t(out)].find<BoundaryChosen>();
            const bool slit = hit != nullptr && trace.objects[std::size_t(hit->object)].name == "slit";
            const Vec3d from = trace.rays[std::size_t(out)].start().origin,
                        d = trace.rays[std::size_t(out)].start().direction;
            const Vec3d to = slit ? hit->point : from + d * ((7.3 - dot(from, right)) / dot(d, right));
            svg.line(sheet(from), sheet(to), {drawing::ray_colour(ray), slit ? 4.0 : 1.8});
            ends.push_back({sheet(to), &ray, slit});
        }
    }
    // Where the rays end there is no room for words: thin lines lead to them.
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.at.y < b.at.y; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const End& end = ends[i];
        const double row = 336 + 26 * (double(i) - double(ends.size() - 1) / 2);
        svg.path({end.at, {784, end.at.y}, {840, row}}, {grey, 1});
        svg.text(
            {846, row}, digits(end.ray->start().wavelength, 0) + " nm" + (end.slit ? " ●" : ""),
            {18, drawing::mixed(drawing::ray_text_colour(*end.ray), black, 0.35), end.slit, Anchor::start});
    }
    const auto slit_cut = cut("slit");
    for (const auto& part : slit_cut) svg.area(part, {black});
    const Pixel slit = slit_cut.at(0).at(0);
    svg.line({slit.x, slit.y + 12}, {slit.x - 20, 470}, {grey, 1.5});
    svg.text({slit.x - 20, 488}, "bright slit", {20, black, true});
    svg.text({sheet(start).x + 44, sheet(start).y - 14}, "eye's ray: all wavelengths",
             {20, black, true, Anchor::start});
    svg.text({160, 268}, "flint", {19});
    svg.text({500, 536}, "thick, ●: meets the slit and brings its light; thin: goes past it", {20});

    RenderOptions options;
    options.width = 320;
    options.height = 240;
    svg.image({290, 12, 320, 240}, png_of(render(subject.bench, options).image));
    svg.frame({290, 12, 320, 240}, {grey, 1.5});
    svg.circle({290 + x / 2.0, 12 + y / 2.0}, 9, {white, 2.5});
    svg.text({626, 40}, "the image; in the", {18, black, false, Anchor::start});
    svg.text({626, 66}, "ring, this ray's pixel", {18, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
