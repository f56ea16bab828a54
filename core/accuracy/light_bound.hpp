#pragma once
// How much light can come back along a ray that is not followed.

#include "core/world/world.hpp"

namespace rayscope {

/// No ray brings more than this, per colour. L ≤ max(background, local + ρ L), with ρ the largest share that a material
/// sends on, and `local` the brightest surface in all lights. Where ρ ≥ 1 nothing bounds the sum for ever: then it is
/// that of `bounces` more.
[[nodiscard]] Colour light_bound(const WorldBase& world, int bounces);

} // namespace rayscope
