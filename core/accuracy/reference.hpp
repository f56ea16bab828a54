#pragma once
// The image that all others are measured against: float128, the stable formulas, deep, the largest weights first.

#include "core/scene/scene.hpp"
#include "core/tracer/reference_samples.hpp"

#include <filesystem>

namespace rayscope {

struct ReferenceLimits {
    int max_depth = 64;
    double min_weight = 1 / 1e6;
    int max_rays = 100000; ///< of a pixel
};

struct ReferenceOptions {
    int width = 0, height = 0;
    ReferenceLimits limits;
    int threads = 0;
    std::filesystem::path cache; ///< folder for finished and half-finished references; empty: none
    std::string identity;        ///< of the scene's content: what it was read from, or a hash of that
    std::function<void(double)> progress;
    const std::atomic<bool>* stop = nullptr;
};

struct Reference {
    int width = 0, height = 0;
    ReferenceLimits limits;
    std::vector<ReferenceSample> samples; ///< row by row
    std::vector<double>
        uncertainty; ///< of each pixel: what the rays not followed can bring at most, largest colour
    double uncertainty_mean = 0, uncertainty_max = 0;
    double relative_rmse_floor = 0; ///< below it a relative RMSE against this reference says nothing
    std::string note;               ///< what went wrong with the cache, if anything

    [[nodiscard]] bool complete() const { return samples.size() == std::size_t(width) * std::size_t(height); }
};

/// Takes what the cache has, computes the rest, and keeps it there every few seconds and when it is stopped: the next
/// call goes on from there. Not complete() if it was stopped.
[[nodiscard]] Reference make_reference(const Scene& scene, const ReferenceOptions& options);

} // namespace rayscope
