#pragma once
// Questions that every view asks of a traced ray.

#include "core/rayscope.hpp"

#include <string>
#include <vector>

namespace rayscope::drawing {

/// A shadow ray that something opaque stops before the light.
[[nodiscard]] bool is_blocked(const TracedRay& ray);

/// Where a ray's line is drawn to: its hit, its light, what blocks it, or, open, as far as `open_length` (world).
struct RayEnd {
    double t = 0;
    Vec3d point{0};
    bool open = false;
};
[[nodiscard]] RayEnd drawn_end(const TracedRay& ray, double open_length);

/// "bowl", "light key", "nothing": what the ray arrived at.
[[nodiscard]] std::string target_name(const Trace& trace, const TracedRay& ray);

/// From the first ray to this one, both included.
[[nodiscard]] std::vector<int> path_to(const Trace& trace, int ray);

/// A name from one of the trace's tables; empty if there is none.
[[nodiscard]] std::string object_name(const Trace& trace, Id object);
[[nodiscard]] std::string medium_name(const Trace& trace, Id medium);

} // namespace rayscope::drawing
