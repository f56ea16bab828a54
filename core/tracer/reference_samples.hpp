#pragma once
// Samples that others are measured against: whatever number of rays they are given, the largest weights come first.

#include "core/tracer/first_hits.hpp"

namespace rayscope {

struct ReferenceSample {
    Colour colour{0};
    Colour lost{0}; ///< the weights of all rays that were not followed, added up
    FirstHit first;
};

/// The rows top … bottom − 1 of an image of this size, within the world's max_depth, min_weight and max_rays. Row by
/// row; incomplete where options.stop was set. (The options' own size is not asked.)
template <Numbers N>
[[nodiscard]] std::vector<ReferenceSample> reference_samples(const World<N>& world, const EyeRays& eye_rays,
                                                             int width, int top, int bottom,
                                                             const RenderOptions& options);

} // namespace rayscope
