#pragma once
// What each eye ray of an image hits first, and where.

#include "core/tracer/render.hpp"

namespace rayscope {

struct FirstHit {
    Id object = none;
    double t = 0;      ///< 0 where nothing is hit
    double t_rest = 0; ///< t + t_rest keep 106 bits of what the scalar type knew
    double bound = 0;  ///< of t's error; 0 for the textbook's formulas, which have none
};

/// Row by row from the top left, through the middles of the pixels; incomplete where options.stop was set.
template <Numbers N>
[[nodiscard]] std::vector<FirstHit> first_hits(const World<N>& world, const Camera& camera,
                                               const RenderOptions& options);

} // namespace rayscope
