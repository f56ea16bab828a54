#pragma once
// The mirrored direction.

#include "core/math/numbers.hpp"
#include "core/math/vec.hpp"

namespace rayscope {

/// l = d − 2 (d·n) n: the direction d mirrored at a plane with unit normal n; the same for n and −n.
/// Stable: divided by n·n, for rounding leaves n a little off unit, which would stretch l by twice as much (so near to 1,
/// 1 / x is 2 − x); and one rounding less in each component. Error of each: about 2ε |d|. (It is the ray's direction that
/// is mirrored. With the hit point in its place, as one finds printed, the result depends on where the origin of the world
/// is.)
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Vec3<T> mirrored(const Vec3<T>& d, const Vec3<T>& n) {
    if constexpr (is_textbook<N>) return d - T(2) * dot(d, n) * n;
    const T scale = T(-2) * dot(d, n) * (T(2) - dot(n, n));
    return {fma(scale, n.x, d.x), fma(scale, n.y, d.y), fma(scale, n.z, d.z)};
}

/// Between a unit direction and a surface with a unit normal against it: radians.
template <Scalar T> [[nodiscard]] double angle_of_incidence(const Vec3<T>& d, const Vec3<T>& n) {
    return std::atan2(double(length(cross(d, n))), double(-dot(d, n)));
}

} // namespace rayscope
