#include "exercises/grader/ray_drawing.hpp"

#include "exercises/grader/divergence_text.hpp"
#include "exercises/grader/ray_lanes.hpp"
#include "exercises/grader/ray_paths.hpp"
#include "exercises/grader/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::exercises {
namespace {

std::string legend_entry(const char* whose, const char* words) {
    return fmt::format(
        "<svg class=\"key\" viewBox=\"0 0 48 12\" aria-hidden=\"true\"><line class=\"{0}\" x1=\"2\" "
        "y1=\"6\" x2=\"30\" y2=\"6\"/><rect class=\"{0}\" x=\"34\" y=\"1\" width=\"13\" "
        "height=\"10\"/></svg> {1}\n",
        whose, words);
}

std::string rays_table(const Trace& trace, const char* title) {
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
    return fmt::format("<table><caption>{}</caption><tr><th>ray</th><th>kind</th><th>from</th>"
                       "<th>direction</th><th>hits</th></tr>\n{}</table>\n",
                       title, rows);
}

} // namespace

const char* const ray_drawing_style = R"(svg { width: 100%; font-size: 12px; } svg line { stroke: #999; }
svg .start { stroke: #999; stroke-dasharray: 1 3; } svg text { fill: #222; }
svg line.right { stroke: #2166ac; stroke-width: 5; } svg line.yours { stroke: #d6604d; stroke-width: 2.5; stroke-dasharray: 7 4; }
svg rect.right { fill: #2166ac; stroke: #2166ac; } svg rect.yours { fill: #fff; stroke: #d6604d; stroke-width: 2; stroke-dasharray: 7 4; }
svg circle.right { fill: #2166ac; } svg circle.yours { fill: #fff; stroke: #d6604d; stroke-width: 2; }
svg.key { width: 4em; vertical-align: middle; } caption { text-align: left; font-weight: bold; padding-top: .6rem; }
)";

std::string drawn_runs(const ShownRuns& runs) {
    const Trace* const yours = runs.yours ? &*runs.yours : nullptr;
    std::string html = "<p>" + legend_entry("right", "right: solid line, filled bar");
    if (yours != nullptr) html += "<br>" + legend_entry("yours", "yours: dashed line, hollow bar");
    html += "</p>\n" + drawn_paths(runs.right, yours) + drawn_lanes(runs.right, yours);
    if (yours != nullptr)
        html += "<pre>" + in_markup(divergence_text(runs.right, *yours).text) + "</pre>\n";
    else
        html += "<p>No ray follows from this answer; what was expected and what came stands above.</p>\n";
    html += rays_table(runs.right, "right");
    if (runs.parted) html += rays_table(*yours, "yours");
    return html;
}

} // namespace rayscope::exercises
