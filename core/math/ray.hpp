#pragma once
// The ray and the part of it that counts.

#include "core/math/vec.hpp"

namespace rayscope {

/// The points origin + t·direction. The direction need not be unit: t is measured in its lengths, so that a ray
/// moved into object space keeps its t.
template <Scalar T> struct Ray {
    Vec3<T> origin;
    Vec3<T> direction;

    [[nodiscard]] Vec3<T> at(T t) const {
        return {fma(t, direction.x, origin.x), fma(t, direction.y, origin.y), fma(t, direction.z, origin.z)};
    }
};

/// The ray in another number type, each component rounded.
template <Scalar To, Scalar From> [[nodiscard]] Ray<To> as(const Ray<From>& ray) {
    return {as<To>(ray.origin), as<To>(ray.direction)};
}

/// The open interval of t in which a crossing counts.
template <Scalar T> struct Range {
    T min = T(0);
    T max = infinity<T>;

    [[nodiscard]] bool contains(T t) const { return min < t && t < max; }
};

} // namespace rayscope
