#include "bench/stages/stage_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rayscope::bench {
namespace {

const char* name_of(Rays rays) { return rays_names[std::size_t(rays)]; }

// Rows of one scene stand together.
std::vector<std::vector<StageRun>> by_scene(const std::vector<StageRun>& runs) {
    std::vector<std::vector<StageRun>> groups;
    for (const StageRun& run : runs) {
        if (groups.empty() || groups.back().front().scene != run.scene) groups.emplace_back();
        groups.back().push_back(run);
    }
    return groups;
}

std::string table_of(const std::vector<StageRun>& runs) {
    std::string text = "| stage | rays | ns a ray | tests a ray | cells a ray | build, ms | MB |\n"
                       "| --- | --- | --: | --: | --: | --: | --: |\n";
    for (const StageRun& run : runs)
        text +=
            fmt::format("| {} | {} | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {} |\n", run.stage,
                        name_of(run.rays), run.nanoseconds, run.tests, run.cells, 1000 * run.build_seconds,
                        run.bytes == 0 ? "–" : fmt::format("{:.2f}", double(run.bytes) / 1e6));
    return text;
}

// For one kind of ray: the quickest, beside the slowest that was measured.
std::string verdict_of(const std::vector<StageRun>& runs, Rays rays) {
    std::vector<const StageRun*> rivals;
    for (const StageRun& run : runs)
        if (run.rays == rays) rivals.push_back(&run);
    if (rivals.empty()) return "";
    const auto slower = [](const auto* a, const auto* b) { return a->nanoseconds < b->nanoseconds; };
    const StageRun& best = **std::min_element(rivals.begin(), rivals.end(), slower);
    const StageRun& base = *rivals.front();
    std::string text = fmt::format("- **{}** rays: {} is the quickest", name_of(rays), best.stage);
    if (&best != &base)
        text += fmt::format(", {:.1f} times as quick as {} ({:.1f} tests a ray instead of {:.1f})",
                            base.nanoseconds / best.nanoseconds, base.stage, best.tests, base.tests);
    for (const StageRun* run : rivals)
        if (run != &base && run->nanoseconds > base.nanoseconds)
            text += fmt::format("; {} loses: {:.1f} times the time of {}", run->stage,
                                run->nanoseconds / base.nanoseconds, base.stage);
    for (const StageRun* run : rivals) {
        const double saved = (base.nanoseconds - run->nanoseconds) * 1e-9;
        if (run != &base && saved > 0 && run->build_seconds / saved > 1e5)
            text += fmt::format("; {} pays only after {:.0f} thousand rays, which its building costs",
                                run->stage, run->build_seconds / saved / 1000);
    }
    return text + ".\n";
}

} // namespace

std::vector<Growth> growth_of(const std::vector<StageRun>& runs) {
    std::vector<Growth> list;
    for (const StageRun& run : runs) {
        if (!run.is_cloud) continue;
        auto found = std::find_if(list.begin(), list.end(), [&](const Growth& g) {
            return g.stage == run.stage && g.rays == run.rays;
        });
        if (found == list.end()) found = list.insert(list.end(), Growth{run.stage, run.rays, {}, 0});
        found->points.emplace_back(double(run.objects), run.nanoseconds);
    }
    for (Growth& growth : list) {
        double x = 0, y = 0, xx = 0, xy = 0;
        const auto count = double(growth.points.size());
        for (const auto& [objects, time] : growth.points) {
            const double a = std::log(objects), b = std::log(time);
            x += a, y += b, xx += a * a, xy += a * b;
        }
        growth.exponent = count > 1 ? (count * xy - x * y) / (count * xx - x * x) : std::nan("");
    }
    return list;
}

std::string csv_of(const std::vector<StageRun>& runs) {
    std::string text = "scene,objects,stage,rays,ns_per_ray,tests_per_ray,cells_per_ray,build_ms,bytes\n";
    for (const StageRun& run : runs)
        text += fmt::format("{},{},{},{},{:.2f},{:.3f},{:.3f},{:.4f},{}\n", run.scene, run.objects, run.stage,
                            name_of(run.rays), run.nanoseconds, run.tests, run.cells,
                            1000 * run.build_seconds, run.bytes);
    return text;
}

std::string json_of(const std::vector<Growth>& growth) {
    nlohmann::json series = nlohmann::json::array();
    for (const Growth& g : growth)
        series.push_back(
            {{"stage", g.stage},
             {"rays", name_of(g.rays)},
             {"exponent", std::isnan(g.exponent) ? nlohmann::json() : nlohmann::json(g.exponent)},
             {"points", g.points}});
    return nlohmann::json{{"growth", series}}.dump(1) + '\n';
}

std::string page_of(const std::vector<StageRun>& runs, const std::vector<Growth>& growth,
                    const std::string& peers) {
    std::string text =
        "# What each stage buys\n\n"
        "Every stage gives the same image and the same answers, bit for bit: that was checked "
        "before any clock "
        "started. *eye* rays go through the pixels, *shadow* rays from what they hit to the "
        "light, *other* rays from "
        "there into random directions: the hardest, since no two go together. A *test* asks "
        "one object for its "
        "crossings; a *cell* is a node, leaf, list or extent that was looked into. Times are medians "
        "of one thread, and only "
        "their ratios mean anything on another machine.\n\n";
    if (!growth.empty()) {
        text += "## Growth\n\nClouds of balls that cover the same area, however many they are. The exponent "
                "k says that "
                "the time grows like N^k: 1 is a scan, 0 would be a time that N does not change.\n\n"
                "| stage | rays | k | ns at the fewest | ns at the most |\n| --- | --- | --: | --: | --: |\n";
        for (const Growth& g : growth)
            text += fmt::format(
                "| {} | {} | {} | {:.0f} at {:.0f} | {:.0f} at {:.0f} |\n", g.stage, name_of(g.rays),
                std::isnan(g.exponent) ? "–" : fmt::format("{:.2f}", g.exponent), g.points.front().second,
                g.points.front().first, g.points.back().second, g.points.back().first);
    }
    for (const auto& rows : by_scene(runs)) {
        text += fmt::format("\n## {}\n\n{} objects.\n\n", rows.front().scene, rows.front().objects);
        for (const Rays rays : {Rays::eye, Rays::shadow, Rays::other}) text += verdict_of(rows, rays);
        text += '\n' + table_of(rows);
    }
    if (!peers.empty()) text += "\n## Peers\n\n```\n" + peers + "```\n";
    return text;
}

} // namespace rayscope::bench
