#pragma once
// The walls of a cylinder and of a cone without their caps: surfaces, not solids. Face 0.

#include "core/generics/cone.hpp"
#include "core/generics/cylinder.hpp"

namespace rayscope {

/// The ends of wall ∩ slab that lie on the wall (face 0), each as an interval without length.
template <Scalar T> [[nodiscard]] Intervals<T> wall_crossings(const Interval<T>& inside) {
    Intervals<T> found;
    if (inside.empty()) return found;
    if (inside.enter_face == 0) found.append({inside.enter, inside.enter, 0, 0});
    if (inside.exit_face == 0) found.append({inside.exit, inside.exit, 0, 0});
    return found;
}

/// The schoolbook's: a wall's hit counts if it lies between the ends.
template <Scalar T> void append_if_within(Intervals<T>& found, T t, T z) {
    if (is_finite(t) && magnitude(z) <= T(1)) found.append({t, t, 0, 0});
}

template <Numbers N> struct OpenCylinder {
    using T = ScalarOf<N>;

    static constexpr const char* name = "open cylinder";
    static constexpr bool solid = false;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if constexpr (is_textbook<N>) {
            Intervals<T> found;
            textbook_wall_hits(ray, [&](T t, T z) { append_if_within(found, t, z); });
            return found;
        }
        const Interval<T> wall = inside_cylinder_wall(ray, 0, leaving == 0);
        return wall_crossings(intersection(slab(ray.origin.z, ray.direction.z, 1, 2, no_face), wall));
    }
    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int /*face*/) const { return {p.x, p.y, T(0)}; }
    [[nodiscard]] T value(const Vec3<T>& p) const { return Cylinder<N>{}.value(p); }
    [[nodiscard]] T curvature(const Vec3<T>& p, const Vec3<T>& d, int face) const {
        return Cylinder<N>{}.curvature(p, d, face);
    }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{T(-1)}, Vec3<T>{T(1)}}; }

    template <Numbers M> [[nodiscard]] OpenCylinder<M> to() const { return {}; }
};

template <Numbers N> struct OpenCone {
    using T = ScalarOf<N>;

    T top = T(0); ///< radius at z = 1; 0 ≤ top < 1

    static constexpr const char* name = "open cone";
    static constexpr bool solid = false;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if constexpr (is_textbook<N>) {
            Intervals<T> found;
            ConeWall<T>(top).textbook_hits(ray, [&](T t, T z) { append_if_within(found, t, z); });
            return found;
        }
        const Interval<T> within = slab(ray.origin.z, ray.direction.z, 1, 2, no_face);
        if (within.empty()) return {};
        return wall_crossings(ConeWall<T>(top).inside(ray, within, 0, leaving == 0));
    }
    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int face) const { return Cone<N>{top}.normal(p, face); }
    [[nodiscard]] T value(const Vec3<T>& p) const { return Cone<N>{top}.value(p); }
    [[nodiscard]] T curvature(const Vec3<T>& p, const Vec3<T>& d, int face) const {
        return Cone<N>{top}.curvature(p, d, face);
    }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{T(-1)}, Vec3<T>{T(1)}}; }

    template <Numbers M> [[nodiscard]] OpenCone<M> to() const { return {ScalarOf<M>(top)}; }
};

} // namespace rayscope
