#pragma once
// What a pixel costs, or which rays bring its light, in place of its colour.

#include "core/trace/events.hpp"
#include "core/world/counters.hpp"

#include <ctime>
#include <numeric>
#include <string_view>

namespace rayscope {

enum class Heat : std::uint8_t {
    tests, ///< generics tested, operands included
    cells, ///< places looked into or passed: nodes, cells, lists, boxes
    depth, ///< of the deepest ray
    time,  ///< of the processor
    rays,
    samples,
    // Means of R, G and B, and over the pixel's samples.
    dropped, ///< weight of the rays that the limits cut off
    // Of the pixel's light what these rays find themselves. They add up to all of it.
    direct, ///< eye rays
    reflected,
    refracted,
};
[[nodiscard]] inline bool is_light(Heat heat) { return heat >= Heat::direct; }
/// The tracer itself knows it of each trace; all others are counted, or time.
[[nodiscard]] inline bool is_of_trace(Heat heat) {
    return heat == Heat::depth || heat == Heat::dropped || is_light(heat);
}

/// By Heat.
struct HeatName {
    std::string_view name, meaning;
};
inline constexpr std::array<HeatName, 10> heat_names{
    {{"tests", "generics tested for each pixel"},
     {"cells", "cells, lists, nodes and boxes visited for each pixel"},
     {"depth", "depth of each pixel's deepest ray"},
     {"time", "processor time of each pixel in microseconds"},
     {"rays", "rays traced for each pixel, shadow rays included"},
     {"samples", "samples taken of each pixel"},
     {"dropped", "weight of the rays that the limits cut off each pixel"},
     {"direct", "light of each pixel that its eye ray finds itself"},
     {"reflected", "light of each pixel that reflected rays bring"},
     {"refracted", "light of each pixel that refracted rays bring"}}};

/// Of a tracer's last trace, where it is_of_trace.
template <typename Tracer> [[nodiscard]] float heat_of_trace(Heat heat, const Tracer& tracer) {
    if (heat == Heat::depth) return float(tracer.deepest());
    if (heat == Heat::dropped) {
        const Colour& dropped = tracer.dropped();
        return float((dropped.x + dropped.y + dropped.z) / 3);
    }
    if constexpr (Tracer::all_effects)
        return float(tracer.brought().mean(RayKind(int(heat) - int(Heat::direct))));
    return 0;
}

/// Measures what is counted, or time, of one pixel, from its making on.
class HeatMeter {
public:
    HeatMeter(Heat heat, const Counters& counters)
        : heat_(heat), counters_(counters), before_(counted()), start_(processor_time()) {}

    [[nodiscard]] float value() const {
        if (heat_ == Heat::time) return float(processor_time() - start_);
        return float(counted() - before_);
    }

private:
    /// Microseconds of this thread alone: what else the machine does is no cost of the pixel.
    [[nodiscard]] static double processor_time() {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) * 1e6 + double(now.tv_nsec) / 1e3;
    }
    [[nodiscard]] std::uint64_t counted() const {
        const auto sum = [](const auto& counts) {
            return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
        };
        switch (heat_) {
        case Heat::tests: return sum(counters_.tests);
        case Heat::cells: return counters_.nodes + counters_.cells + counters_.boxes;
        case Heat::rays: return sum(counters_.rays);
        case Heat::depth:
        case Heat::time:
        case Heat::samples:
        case Heat::dropped:
        case Heat::direct:
        case Heat::reflected:
        case Heat::refracted: break; // not counted
        }
        return 0;
    }

    Heat heat_;
    const Counters& counters_;
    std::uint64_t before_;
    double start_;
};

} // namespace rayscope
