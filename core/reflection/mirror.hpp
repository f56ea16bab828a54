#pragma once
// The mirrored direction.

#include "core/math/vec.hpp"

namespace rayscope {

/// l = d − 2 (d·n) n: the direction d mirrored at a plane with unit normal n. Keeps the length of d, and is the same
/// for n and −n. (It is the ray's direction that is mirrored. With the hit point in its place, as one finds printed,
/// the result depends on where the origin of the world is.)
template <Scalar T> [[nodiscard]] Vec3<T> mirrored(const Vec3<T>& d, const Vec3<T>& n) {
    return d - (T(2) * dot(d, n)) * n;
}

} // namespace rayscope
