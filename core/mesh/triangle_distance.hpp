#pragma once
// How far a point is from a triangle.

#include "core/math/vec.hpp"

namespace rayscope {

[[nodiscard]] inline double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
    const Vec3d along = b - a;
    const double square = dot(along, along);
    const double share = square > 0 ? minimum(1.0, maximum(0.0, dot(p - a, along) / square)) : 0.0;
    return length(p - a - share * along);
}

/// To its plane where the foot of the perpendicular lies within it, else to the nearest edge.
[[nodiscard]] inline double distance_to_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b,
                                                 const Vec3d& c) {
    const Vec3d n = normalized(cross(b - a, c - a));
    const auto left_of = [&](const Vec3d& from, const Vec3d& to) {
        return dot(cross(to - from, p - from), n) >= 0;
    };
    if (length(n) > 0 && left_of(a, b) && left_of(b, c) && left_of(c, a)) return magnitude(dot(n, p - a));
    return minimum(distance_to_segment(p, a, b),
                   minimum(distance_to_segment(p, b, c), distance_to_segment(p, c, a)));
}

} // namespace rayscope
