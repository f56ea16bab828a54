#pragma once
// What each configuration costs, and how wrong it is.

#include "core/accuracy/configuration.hpp"
#include "core/accuracy/image_error.hpp"

namespace rayscope {

/// Of tracing alone: processor seconds of one image.
struct Cost {
    double median = 0, min = 0, max = 0;
    int runs = 0;
};

struct Measured {
    Configuration configuration;
    Cost seconds;
    ImageError error;
    bool on_front = false; ///< nothing that costs less is as near to the reference
    std::string map;       ///< file name of its error map, if there is one
};

struct MeasureOptions {
    int runs = 5;
    int threads = 0;
    std::function<void(double)> progress;
    const std::atomic<bool>* stop = nullptr;
    /// Takes the CIEDE2000 of each pixel of a configuration; returns what becomes Measured::map.
    std::function<std::string(const Configuration&, const Map&)> on_map;
};

/// Renders in turn, A B C A B C …, so that a machine that slows down slows all of them down. One image is kept at a time.
/// @return empty if it was stopped
[[nodiscard]] std::vector<Measured> measure(const Scene& scene,
                                            const std::vector<Configuration>& configurations,
                                            const Reference& reference, const MeasureOptions& options);

/// The error by which configurations are ranked: the relative RMSE, and nothing below what the reference knows.
[[nodiscard]] double ranked_error(const Measured& measured, const Reference& reference);

} // namespace rayscope
