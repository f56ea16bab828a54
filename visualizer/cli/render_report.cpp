#include "visualizer/cli/render_report.hpp"

#include "visualizer/cli/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace rayscope::cli {
namespace {

/// "12 345 678"
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, " ");
    return digits;
}

std::uint64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

template <std::size_t N, typename NameOf>
std::string counts(const std::array<std::uint64_t, N>& numbers, const NameOf& name_at) {
    std::string text;
    for (std::size_t i = 0; i < N; ++i)
        if (numbers[i] > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name_at(i), grouped(numbers[i]));
    return text.empty() ? "none" : text;
}

const char* ray_kind_at(std::size_t i) { return name_of(RayKind(i)); }
const char* generic_kind_at(std::size_t i) { return generic_name(i); }

std::string octree_text(const OctreeStatistics& octree) {
    std::string text =
        octree.leaves == 0
            ? "octree  none: no object fits into a cell\n"
            : fmt::format("octree  {} nodes, {} leaves with {} entries, {} levels deep, {} bytes\n",
                          grouped(octree.nodes), grouped(octree.leaves), grouped(octree.entries),
                          octree.depth, grouped(octree.bytes));
    if (octree.apart > 0)
        text += fmt::format("        {} in no cell: without end, too far away or too distorted\n",
                            grouped(octree.apart));
    if (octree.leaves == 0) return text;
    text += fmt::format("        at most {} levels: {}\n", octree.limits.depth, octree.reasons.depth);
    text +=
        fmt::format("        more than {} objects: {}\n", octree.limits.capacity, octree.reasons.capacity);
    text += fmt::format("        no cell below {:.3g} of the whole: {}\n", octree.limits.least_size,
                        octree.reasons.least_size);
    return text;
}

nlohmann::json json_of(const OctreeStatistics& octree) {
    return {{"nodes", octree.nodes},
            {"leaves", octree.leaves},
            {"entries", octree.entries},
            {"apart", octree.apart},
            {"depth", octree.depth},
            {"bytes", octree.bytes},
            {"limits",
             {{"depth", {{"value", octree.limits.depth}, {"reason", octree.reasons.depth}}},
              {"capacity", {{"value", octree.limits.capacity}, {"reason", octree.reasons.capacity}}},
              {"least_size", {{"value", octree.limits.least_size}, {"reason", octree.reasons.least_size}}}}}};
}

nlohmann::json json_of(const Seconds& seconds) { return {{"cpu", seconds.cpu}, {"wall", seconds.wall}}; }

} // namespace

double Stopwatch::cpu_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) / 1e9;
}

Seconds Stopwatch::elapsed() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
    return {cpu_now() - cpu_, wall.count()};
}

std::string report_text(const RenderReport& report) {
    const Counters& counters = report.counters;
    const double wall = report.load.wall + report.build.wall + report.trace.wall + report.write.wall;
    std::string text = fmt::format("rays    {}\n", counts(counters.rays, ray_kind_at));
    text += fmt::format("tests   {}; compounds {}\n", counts(counters.tests, generic_kind_at),
                        grouped(counters.compounds));
    text += fmt::format("stage   {}{}{}\n", report.stage, report.stage_reason.empty() ? "" : "; ",
                        report.stage_reason);
    text += fmt::format("        nodes {}, cells {}, boxes {} of which missed {}\n", grouped(counters.nodes),
                        grouped(counters.cells), grouped(counters.boxes), grouped(counters.boxes_missed));
    if (report.octree) text += octree_text(*report.octree);
    text += fmt::format("cut     by depth {}, by weight {}, by max_rays {}; total reflections {}\n",
                        grouped(counters.cut_by_depth), grouped(counters.cut_by_weight),
                        grouped(counters.cut_by_ray_limit), grouped(counters.total_reflections));
    text += fmt::format(
        "time    {:.3f} s: load {:.3f}, build {:.3f}, trace {:.3f} (CPU {:.3f}; {:.3f} for the stage), write "
        "{:.3f}\n",
        wall, report.load.wall, report.build.wall, report.trace.wall, report.trace.cpu, report.stage_build,
        report.write.wall);
    text += fmt::format("image   {} × {} pixels, {} bytes\n", report.width, report.height,
                        grouped(report.file_bytes));
    return text + harmless(report.output) + "\n";
}

std::string report_json(const RenderReport& report) {
    const Counters& counters = report.counters;
    nlohmann::ordered_json json;
    json["format"] = "rayscope-statistics";
    json["version"] = 1;
    json["scene"] = report.scene;
    json["image"] = {{"file", report.output},
                     {"width", report.width},
                     {"height", report.height},
                     {"bytes", report.file_bytes},
                     {"hash", fmt::format("{:016x}", report.image_hash)}};
    json["seconds"] = {{"load", json_of(report.load)},
                       {"build", json_of(report.build)},
                       {"trace", json_of(report.trace)},
                       {"write", json_of(report.write)}};
    for (std::size_t i = 0; i < counters.rays.size(); ++i) json["rays"][ray_kind_at(i)] = counters.rays[i];
    for (std::size_t i = 0; i < counters.tests.size(); ++i)
        json["tests"][generic_kind_at(i)] = counters.tests[i];
    json["compounds"] = counters.compounds;
    json["stage"] = {{"choice", report.stage},
                     {"reason", report.stage_reason},
                     {"build_seconds", report.stage_build},
                     {"nodes", counters.nodes},
                     {"cells", counters.cells},
                     {"boxes", counters.boxes},
                     {"boxes_missed", counters.boxes_missed}};
    if (report.octree) json["stage"]["octree"] = json_of(*report.octree);
    json["cut"] = {{"depth", counters.cut_by_depth},
                   {"weight", counters.cut_by_weight},
                   {"max_rays", counters.cut_by_ray_limit}};
    json["total_reflections"] = counters.total_reflections;
    json["peak_memory_bytes"] = peak_memory();
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace rayscope::cli
