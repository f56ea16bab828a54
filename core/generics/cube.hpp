#pragma once
// The cube [−1, 1]³: three slabs. Faces 0 … 5: −x, +x, −y, +y, −z, +z.

#include "core/generics/slab.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

template <Numbers N> struct Cube {
    using T = ScalarOf<N>;

    static constexpr const char* name = "cube";
    static constexpr bool solid = true;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        Interval<T> inside = layer(ray, 0, leaving);
        inside = intersection(inside, layer(ray, 1, leaving));
        inside = intersection(inside, layer(ray, 2, leaving));
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

    template <Numbers M> [[nodiscard]] Cube<M> to() const { return {}; }

private:
    [[nodiscard]] static Interval<T> layer(const Ray<T>& ray, int axis, int leaving) {
        const T o = ray.origin[axis], d = ray.direction[axis];
        if constexpr (is_textbook<N>) return textbook_slab(o, d, 2 * axis, 2 * axis + 1);
        return slab(o, d, 2 * axis, 2 * axis + 1, leaving);
    }
};

} // namespace rayscope
