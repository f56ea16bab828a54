#pragma once
// What a render did and what it cost, for a person and for a program.

#include "core/rayscope.hpp"

#include <chrono>
#include <ctime>
#include <string>

namespace rayscope::cli {

struct Seconds {
    double cpu = 0, wall = 0;
};

/// Runs from its making; CPU time is that of all threads.
class Stopwatch {
public:
    [[nodiscard]] Seconds elapsed() const;

private:
    [[nodiscard]] static double cpu_now();
    double cpu_ = cpu_now();
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

struct RenderReport {
    std::string scene, output;
    int width = 0, height = 0;
    std::uint64_t image_hash = 0;
    std::uintmax_t file_bytes = 0;
    Seconds load, build, trace, write;
    Counters counters;
    std::string stage, stage_reason; ///< how hits were found, and why so; no reason where it was asked for
    double stage_build = 0;          ///< seconds: what it built, part of `trace`
    std::optional<OctreeStatistics> octree;
};

/// A few lines for the terminal.
[[nodiscard]] std::string report_text(const RenderReport& report);

/// Members in chapters/reference/render-statistics.md.
[[nodiscard]] std::string report_json(const RenderReport& report);

} // namespace rayscope::cli
