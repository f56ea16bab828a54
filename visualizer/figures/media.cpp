// Media within media: glass in water in air, by the inside lists and by the notes' rule; and a fan of colours.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::figures {
namespace {

std::size_t drawn_called(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.drawn.size(); ++i) {
        const auto [is_compound, index] = scene.drawn[i];
        if ((is_compound ? scene.compounds[index].name : scene.generics[index].name) == name) return i;
    }
    throw InputError(scene.file, {}, "a figure asks for '" + name + "', which is not drawn");
}

struct Stretch {
    double from, to;
    std::string medium;
};

/// The media along a line, as rays on it tell: each goes on where the last one met a boundary.
std::vector<Stretch> media_along(const Workbench& bench, const Ray<double>& line, double low, double high) {
    std::vector<Stretch> stretches;
    for (double t = low; t < high;) {
        const Trace trace = trace_ray(bench, {line.at(t), line.direction});
        const Id medium = trace.rays[0].start().medium;
        const auto* hit = trace.rays[0].find<BoundaryChosen>();
        const double end = hit != nullptr ? std::min(high, t + hit->boundary.t) : high;
        stretches.push_back({t, end, medium == none ? "air" : trace.media[std::size_t(medium)].name});
        t = end + 1e-6;
    }
    return stretches;
}

void draw_tank(Svg& svg, const Sheet& sheet, const Workbench& bench, const drawing::Area& area) {
    const Scene& scene = bench.scene;
    const auto cut = [&](const char* name) {
        const std::size_t i = drawn_called(scene, name);
        return section(sheet, -1.35, 3.2, [&](const Ray<double>& ray) {
            List list = list_of(bench, ray, i);
            for (auto& [enter, exit] : list) {
                enter = std::max(enter, (area.x - sheet.at.x) / sheet.scale);
                exit = std::min(exit, (area.x + area.width - sheet.at.x) / sheet.scale);
            }
            return list;
        });
    };
    for (const auto& part : cut("lake")) svg.area(part, {sky_blue, 0.35});
    for (auto part : cut("block")) {
        svg.area(part, {green, 0.25});
        part.push_back(part.front());
        svg.path(part, {black, 2.5});
    }
    const double surface = sheet({0, 2.5, 0}).y;
    svg.line({area.x, surface}, {area.x + area.width, surface}, {blue, 2.5});
}

} // namespace

Svg nested_media(const Subject& subject) {
    Svg svg(1000, 710);
    const Ray<double> ray{{0, -0.5, 0}, {1, 1, 0}};
    Scene by_notes = subject.bench.scene;
    by_notes.notes_media = true;
    const Workbench notes = make_workbench(std::move(by_notes));
    struct Side {
        const Workbench& bench;
        double x;
        const char *title, *what;
        Rgb colour;
    };
    for (const Side& side :
         {Side{subject.bench, 10, "media by the inside lists", "goes on into the water", vermilion},
          Side{notes, 510, "the notes: outside is air", "is mirrored for ever", blue}}) {
        const drawing::Area area{side.x, 44, 480, 410};
        const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {side.x + 110, 332}, 90};
        svg.text({side.x + 240, 22}, side.title, {22, black, true});
        draw_tank(svg, sheet, side.bench, area);
        svg.frame(area, {grey, 1.5});
        const bool truth = &side.bench == &subject.bench;
        const Trace trace = trace_ray(side.bench, ray);
        svg.line(sheet({0.35, 0.5, 0}), sheet({1.9, 0.5, 0}), {grey, 1.5, "3 5"});
        if (truth) svg.line(sheet(ray.at(1)), sheet(ray.at(3.5)), {grey, 2, "3 6"});
        int here = 0;
        for (int piece = 0; piece < (truth ? 3 : 4); ++piece) {
            const Vec3d from = trace.rays[std::size_t(here)].start().origin,
                        to = end_point(trace, here, 0.75);
            const Pen pen = pen_of(trace.rays[std::size_t(here)].start().kind, 4);
            svg.line(sheet(from), sheet(to), pen);
            svg.heading(sheet(from), sheet(to), pen);
            if (piece == (truth ? 2 : 3)) break;
            here = child_of(trace, here, truth ? RayKind::refracted : RayKind::reflected);
        }
        svg.dot(sheet(ray.origin), 7, black);
        svg.dot(sheet(hit_of(trace, 0).point), 7, purple);
        const Pixel beside = sheet({1.2, 0, 0});
        if (const auto* bent = trace.rays[0].find<Refracted>(); bent != nullptr)
            svg.text(beside, "θ₁ = " + in_degrees(bent->theta_from) + ", θ₂ = " + in_degrees(bent->theta_to),
                     {19, side.colour, true, Anchor::start});
        if (const auto* total = trace.rays[0].find<TotallyReflected>(); total != nullptr)
            svg.text(beside,
                     "θ₁ = " + in_degrees(total->theta_from) + ", critical " + in_degrees(total->critical),
                     {19, side.colour, true, Anchor::start});
        svg.text({beside.x, beside.y + 30}, side.what, {19, side.colour, true, Anchor::start});
        svg.text({side.x + 14, sheet({0, 2.8, 0}).y}, "air", {19, black, false, Anchor::start});
        svg.text({side.x + 14, sheet({0, 2.2, 0}).y}, "water", {19, black, false, Anchor::start});
        svg.text(sheet({0.25, -0.8, 0}), "glass", {19, black, false, Anchor::start});
    }
    const Line line{400, 145, -1, 3.6, 44, 20};
    svg.text({20, 490}, "on the line of the first ray, e = (0, −0.5, 0), d = (1, 1, 0):",
             {20, black, true, Anchor::start});
    const auto list = [&](const char* name) {
        return list_of(subject.bench, ray, drawn_called(subject.bench.scene, name));
    };
    const double axis = draw_lanes(svg, line, 530,
                                   {{"inside the lake", list("lake"), sky_blue},
                                    {"inside the block", list("block"), green},
                                    {"medium", {}, grey}});
    const double y = axis - line.lane;
    svg.rectangle({line(line.low) - 2, y - 16, line(line.high) - line(line.low) + 4, 32}, {white});
    for (const Stretch& stretch : media_along(subject.bench, ray, line.low, line.high)) {
        const bool block = stretch.medium == "block", lake = stretch.medium == "lake";
        const Rgb colour = block ? green : lake ? sky_blue : pale;
        svg.rectangle({line(stretch.from), y - 15, line(stretch.to) - line(stretch.from), 30}, {colour, 0.6});
        svg.text({line((stretch.from + stretch.to) / 2), y},
                 block  ? "glass"
                 : lake ? "water"
                        : "air",
                 {19, black, true});
    }
    return svg;
}

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
    for (auto part : cut("prism")) {
        svg.area(part, {sky_blue, 0.3});
        part.push_back(part.front());
        svg.path(part, {black, 2.5});
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
