#pragma once
// From what the author wrote to what the tracer reads.

#include "core/scene/scene.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// Throws InputError where a drawn object has no material, or a compound grows too large or meets a singular matrix.
template <Numbers N = double> [[nodiscard]] World<N> build(const Scene& scene);

} // namespace rayscope
