// Media within media: glass in water in air, by the inside lists and by the notes' rule.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"

#include <algorithm>

namespace rayscope::figures {
namespace {

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
    for (const auto& part : cut("block")) {
        svg.area(part, {green, 0.25});
        svg.outline(part, {black, 2.5});
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
                                    {"medium", {}, grey, true}});
    const double y = axis - line.lane;
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

} // namespace rayscope::figures
