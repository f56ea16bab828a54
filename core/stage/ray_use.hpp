#pragma once
// What a ray is for: some stages keep lists for a pixel, or for a light.

#include "core/trace/events.hpp"

namespace rayscope {

struct RayUse {
    RayKind kind = RayKind::eye;
    int x = none, y = none; ///< eye rays: the pixel that they go through; none for a ray given by hand
    Id light = none;        ///< shadow rays: the light that they ask for
};

} // namespace rayscope
