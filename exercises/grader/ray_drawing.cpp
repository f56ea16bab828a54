#include "exercises/grader/ray_drawing.hpp"

#include "core/files/markup.hpp"
#include "core/rayscope.hpp"
#include "exercises/grader/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace rayscope::exercises {
namespace {

constexpr double drawing_width = 640, lane_height = 24, margin = 90;

Ray<double> parsed(const std::string& text) {
    std::array<double, 6> numbers{};
    const char* at = text.c_str();
    for (double& number : numbers) {
        char* end = nullptr;
        number = std::strtod(at, &end);
        at = *end == ',' ? end + 1 : end;
    }
    return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

/// From t to the place in the drawing.
struct Scale {
    double least = 0, most = 1;
    [[nodiscard]] double operator()(double t) const {
        const double share = (std::clamp(t, least, most) - least) / (most - least);
        return margin + share * (drawing_width - margin - 10);
    }
};

Scale scale_of(const std::vector<Spans<double>>& objects) {
    Scale scale{0, 1};
    for (const auto& list : objects)
        for (const auto& span : list)
            for (const double t : {span.enter.t, span.exit.t})
                if (std::isfinite(t)) {
                    scale.least = std::min(scale.least, t);
                    scale.most = std::max(scale.most, t);
                }
    const double border = 0.1 * (scale.most - scale.least);
    return {scale.least - border, scale.most + border};
}

/// A lane for each object: where the line of the ray is inside it.
std::string lanes(const Workbench& bench, const Ray<double>& ray, const Trace& trace) {
    const auto objects = spans(bench, ray);
    const Scale x = scale_of(objects);
    const double height = lane_height * double(objects.size() + 1);
    std::string svg =
        fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"inside intervals of the ray\">\n",
                    drawing_width, height + 6);
    const double start = x(0);
    svg += fmt::format("<line class=\"start\" x1=\"{0:.1f}\" y1=\"0\" x2=\"{0:.1f}\" y2=\"{1}\"/>"
                       "<text x=\"{0:.1f}\" y=\"{2}\">t = 0</text>\n",
                       start, height - lane_height + 4, height);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const double y = lane_height * double(i);
        const std::string name = i < trace.objects.size() ? trace.objects[i].name : "";
        svg += fmt::format(
            "<text x=\"2\" y=\"{:.1f}\">{}</text><line x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\"/>\n",
            y + 16, in_markup(name), margin, y + 12, drawing_width - 10, y + 12);
        for (const auto& span : objects[i])
            svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"12\"><title>{:.6g} "
                               "to {:.6g}</title></rect>\n",
                               x(span.enter.t), y + 6, std::max(1.0, x(span.exit.t) - x(span.enter.t)),
                               span.enter.t, span.exit.t);
    }
    return svg + "</svg>\n";
}

std::string rays_table(const Trace& trace) {
    constexpr std::size_t most_rows = 24;
    std::string rows;
    for (std::size_t i = 0; i < std::min(trace.rays.size(), most_rows); ++i) {
        const RaySpawned& start = trace.rays[i].start();
        std::string hit = "nothing";
        if (const auto* chosen = trace.rays[i].find<BoundaryChosen>())
            hit = fmt::format("{} at t = {:.6g}", in_markup(trace.objects[std::size_t(chosen->object)].name),
                              chosen->boundary.t);
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", i,
                            name_of(start.kind), vector_text(start.origin), vector_text(start.direction),
                            start.kind == RayKind::shadow ? "" : hit);
    }
    return "<table><tr><th>ray</th><th>kind</th><th>from</th><th>direction</th><th>hits</th></tr>\n" + rows +
           "</table>\n";
}

} // namespace

std::string drawn_ray(const std::filesystem::path& scene, const std::string& ray) {
    const Workbench bench = open(scene);
    const Ray<double> given = parsed(ray);
    const Trace trace = trace_ray(bench, given);
    return lanes(bench, given, trace) + rays_table(trace);
}

} // namespace rayscope::exercises
