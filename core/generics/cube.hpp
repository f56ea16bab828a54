#pragma once
// The cube [−1, 1]³: three slabs. Faces 0 … 5: −x, +x, −y, +y, −z, +z.

#include "core/generics/slab.hpp"
#include "core/math/box.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

template <Scalar T> struct Cube {
    static constexpr const char* name = "cube";
    static constexpr bool solid = true;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        Interval<T> inside = slab(ray.origin.x, ray.direction.x, 0, 1, leaving);
        inside = intersection(inside, slab(ray.origin.y, ray.direction.y, 2, 3, leaving));
        inside = intersection(inside, slab(ray.origin.z, ray.direction.z, 4, 5, leaving));
        return Intervals<T>(inside);
    }

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& /*p*/, int face) const {
        Vec3<T> n{T(0)};
        n[face / 2] = face % 2 == 0 ? T(-1) : T(1);
        return n;
    }
    [[nodiscard]] T value(const Vec3<T>& p) const { return largest_component(absolute(p)) - T(1); }
    [[nodiscard]] T curvature(const Vec3<T>&, const Vec3<T>&, int /*face*/) const { return T(0); }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{T(-1)}, Vec3<T>{T(1)}}; }
};

} // namespace rayscope
