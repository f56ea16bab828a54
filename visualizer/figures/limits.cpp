// What a limit of depth costs, and what one of weight would have cut.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::figures {
namespace {

constexpr int deepest = 72;

struct Series {
    double coefficient;
    Rgb colour;
    const char* dash;
    std::vector<double> grey,
        cut;      ///< by max_depth: what comes back, and the weight of the ray that was not sent
    int ends = 0; ///< the depth of the last ray where min_weight alone ends it
};

double cut_weight(const Trace& trace) {
    for (const Event& event : trace.rays.back().events)
        if (const auto* cut = std::get_if<NotSpawned>(&event);
            cut != nullptr && cut->kind == RayKind::reflected)
            return largest_component(cut->weight);
    throw InputError(trace.source.scene, {}, "a figure's ray is not cut");
}

/// Traced again for each limit.
void measure(const Subject& subject, Series& series, double least) {
    Scene scene = subject.bench.scene;
    for (SceneMaterial& material : scene.materials) material.reflection = Colour{series.coefficient};
    Workbench bench = make_workbench(std::move(scene));
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
    bench.world.min_weight = 0;
    for (int depth = 0; depth <= deepest; ++depth) {
        bench.world.max_depth = depth;
        const Trace trace = trace_ray(bench, ray);
        series.grey.push_back(trace.colour.x);
        series.cut.push_back(cut_weight(trace));
    }
    bench.world.max_depth = 250;
    bench.world.min_weight = least;
    series.ends = trace_ray(bench, ray).rays.back().start().depth;
}

void mark(Svg& svg, std::size_t shape, Pixel p, Rgb colour) {
    if (shape == 0) svg.dot(p, 7, colour);
    if (shape == 1) svg.rectangle({p.x - 6, p.y - 6, 12, 12}, {colour});
    if (shape == 2) svg.area({{p.x, p.y - 8}, {p.x + 8, p.y + 6}, {p.x - 8, p.y + 6}}, {colour});
}

} // namespace

Svg depth_and_weight(const Subject& subject) {
    constexpr double least = 0.001;
    Svg svg(1000, 790);
    Series all[] = {{0.9, blue, "", {}, {}}, {0.7, vermilion, "12 5", {}, {}}, {0.5, green, "4 5", {}, {}}};
    for (Series& series : all) measure(subject, series, least);
    const auto x_of = [](double depth) { return 100 + depth * 10.6; };
    const auto y_grey = [](double level) { return 330 - level * 270; };
    const auto y_cut = [](double share) { return 440 - std::log10(share) * 70; };

    svg.text({100, 24}, "brightness that comes back between mirrors of 0.9, 0.7, 0.5",
             {21, black, true, Anchor::start});
    svg.text({100, 404}, "weight of the ray that was cut", {21, black, true, Anchor::start});
    for (int i = 0; i <= 4; ++i) {
        const double grey_level = i / 4.0;
        svg.line({100, y_grey(grey_level)}, {x_of(deepest), y_grey(grey_level)}, {pale, 1.5});
        svg.text({88, y_grey(grey_level)}, digits(grey_level), {18, black, false, Anchor::end});
    }
    for (int i = 0; i <= 3; ++i) {
        const double share = std::pow(10.0, -i);
        svg.line({100, y_cut(share)}, {x_of(deepest), y_cut(share)}, {pale, 1.5});
        svg.text({88, y_cut(share)}, digits(share, 3), {18, black, false, Anchor::end});
    }
    svg.line({100, y_cut(least)}, {x_of(deepest), y_cut(least)}, {black, 2, "8 5"});
    for (const double bottom : {330.0, 680.0}) {
        svg.line({100, bottom}, {x_of(deepest), bottom}, {black, 2});
        for (int depth = 0; depth <= deepest; depth += 10) {
            svg.line({x_of(depth), bottom}, {x_of(depth), bottom + 7}, {black, 2});
            svg.text({x_of(depth), bottom + 22}, std::to_string(depth), {18, black});
        }
    }
    svg.text({x_of(36), 730}, "max_depth", {21, black, true});
    for (std::size_t i = 0; i < std::size(all); ++i) {
        const Series& series = all[i];
        std::vector<Pixel> grey_line, cut_line;
        for (int depth = 0; depth <= deepest; ++depth) {
            grey_line.push_back({x_of(depth), y_grey(series.grey[std::size_t(depth)])});
            if (const double cut = series.cut[std::size_t(depth)]; y_cut(cut) <= 680)
                cut_line.push_back({x_of(depth), y_cut(cut)});
        }
        svg.path(grey_line, {series.colour, 3.5, series.dash});
        svg.path(cut_line, {series.colour, 3.5, series.dash});
        // Where the weight limit would have stopped by itself.
        const std::size_t end = std::size_t(series.ends);
        svg.line({x_of(series.ends), y_grey(series.grey[end])}, {x_of(series.ends), 330},
                 {series.colour, 1.5, "3 5"});
        mark(svg, i, {x_of(series.ends), y_grey(series.grey[end])}, series.colour);
        svg.text({x_of(deepest) + 12, grey_line.back().y}, digits(series.coefficient),
                 {20, series.colour, true, Anchor::start});
        constexpr Pixel beside[] = {{630, 560}, {266, 560}, {122, 560}};
        svg.text(beside[i], digits(series.coefficient), {20, series.colour, true});
        mark(svg, i, {x_of(series.ends), y_cut(series.cut[end])}, series.colour);
    }
    svg.text({x_of(46), 627}, "min_weight " + digits(least, 3), {20, black, true, Anchor::end});
    svg.text({x_of(36), 768},
             "marks: min_weight alone ends it, at depth " + std::to_string(all[2].ends) + ", " +
                 std::to_string(all[1].ends) + " and " + std::to_string(all[0].ends),
             {20});
    return svg;
}

} // namespace rayscope::figures
