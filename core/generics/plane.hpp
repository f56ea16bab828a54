#pragma once
// The half space z ≤ 0, a solid without end. Face 0 is its boundary, outward normal +z.

#include "core/generics/spans.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

template <Numbers N> struct Plane {
    using T = ScalarOf<N>;

    static constexpr const char* name = "plane";
    static constexpr bool solid = true;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        const T o = ray.origin.z, d = ray.direction.z;
        if (d == T(0)) // parallel: wholly inside or wholly outside; the boundary itself is inside
            return Intervals<T>(o <= T(0) && leaving != 0 ? Interval<T>{} : Interval<T>::nothing());
        const T t = leaving == 0 ? T(0) : -o / d;
        return Intervals<T>(d > T(0) ? Interval<T>{-infinity<T>, t, 0, 0}
                                     : Interval<T>{t, infinity<T>, 0, 0});
    }

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& /*p*/, int /*face*/) const { return {T(0), T(0), T(1)}; }
    [[nodiscard]] T value(const Vec3<T>& p) const { return p.z; }
    [[nodiscard]] T curvature(const Vec3<T>&, const Vec3<T>&, int /*face*/) const { return T(0); }
    [[nodiscard]] Box<T> bounds() const {
        return {Vec3<T>{-infinity<T>}, Vec3<T>{infinity<T>, infinity<T>, T(0)}};
    }

    template <Numbers M> [[nodiscard]] Plane<M> to() const { return {}; }
};

} // namespace rayscope
