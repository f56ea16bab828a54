#pragma once
// Which ray of a trace was sent for what.

#include "core/trace/trace.hpp"

namespace rayscope {

/// The children of a kind: several refracted ones where each carries a wavelength.
[[nodiscard]] std::vector<int> children_of(const Trace& trace, const TracedRay& ray, RayKind kind);

/// The shadow ray that asked for this light, or this point of its area: of several the one with its direction; or none.
/// @param likely the one that did in another trace: taken where it asks for this light and none has the direction
[[nodiscard]] int shadow_ray_of(const Trace& trace, const TracedRay& ray, const LightLit& lit,
                                int likely = none);

} // namespace rayscope
