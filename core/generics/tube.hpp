#pragma once
// The round walls, without caps: where a line is inside the endless cylinder, and inside one nappe of a cone.

#include "core/generics/spans.hpp"
#include "core/math/ray.hpp"
#include "core/math/roots.hpp"

namespace rayscope {

/// The t with x² + y² < 1, by the distance of the line from the axis (see Sphere), in the plane z = 0.
/// @param leaving true if the ray starts on the wall: one root is 0 exactly
template <Scalar T>
[[nodiscard]] Interval<T> inside_cylinder_wall(const Ray<T>& ray, int face, bool leaving) {
    const T ox = ray.origin.x, oy = ray.origin.y, dx = ray.direction.x, dy = ray.direction.y;
    const T A = fma(dx, dx, dy * dy);
    const T B = fma(ox, dx, oy * dy);
    if (A == T(0)) { // along the axis
        const bool inside = fma(ox, ox, oy * oy) <= T(1);
        return inside && !leaving ? Interval<T>{} : Interval<T>::nothing();
    }
    if (leaving) {
        const T other = T(-2) * B / A;
        return {minimum(T(0), other), maximum(T(0), other), face, face};
    }
    const T rough = -B / A;
    const T qx = fma(rough, dx, ox), qy = fma(rough, dy, oy);
    const T residual = fma(qx, dx, qy * dy) / A;
    const T squared = fma(residual * residual, A, T(1) - fma(qx, qx, qy * qy));
    if (!(squared > T(0))) return Interval<T>::nothing();
    const T half = sqrt(squared / A);
    const T middle = rough - residual;
    Interval<T> inside{middle - half, middle + half, face, face};
    const T C = fma(ox, ox, fma(oy, oy, T(-1)));
    mend_small_root(inside.enter, inside.exit, half, A, C);
    return inside;
}

/// The schoolbook's hits with that wall: hit(t, z) for each.
template <Scalar T, typename OnHit> void textbook_wall_hits(const Ray<T>& ray, const OnHit& hit) {
    const Vec3<T>&o = ray.origin, &d = ray.direction;
    const auto roots = textbook_quadratic_roots(d.x * d.x + d.y * d.y, T(2) * (o.x * d.x + o.y * d.y),
                                                o.x * o.x + o.y * o.y - T(1));
    if (!roots) return;
    hit(roots->first, o.z + roots->first * d.z);
    hit(roots->second, o.z + roots->second * d.z);
}

/// The schoolbook's hit with the disc of this radius in the plane z = height: hit(t).
template <Scalar T, typename OnHit>
void textbook_cap_hits(const Ray<T>& ray, T height, T radius, const OnHit& hit) {
    const T t = (height - ray.origin.z) / ray.direction.z;
    const T x = ray.origin.x + t * ray.direction.x, y = ray.origin.y + t * ray.direction.y;
    if (x * x + y * y <= radius * radius) hit(t);
}

/// The wall of a cone that narrows from radius 1 at z = −1 to `top` at z = 1: radius w(z) = mean − slope z.
template <Scalar T> struct ConeWall {
    T mean, slope;

    explicit ConeWall(T top) : mean((T(1) + top) / T(2)), slope((T(1) - top) / T(2)) {}
    [[nodiscard]] T radius(T z) const { return fma(-slope, z, mean); }

    /// The t with x² + y² < w², on the nappe w > 0; `within` is the slab, where that nappe is the only one.
    /// With (x, y, w) and their directions, A t² + 2 B t + C < 0 for the form x² + y² − w²; taken about the point
    /// of the line closest to the apex, where nothing large is left to cancel. The discriminant is a sum of three
    /// squared minors (Lagrange's identity for the form), each within 2 ulp: B² − AC would lose everything for a
    /// ray along a generator.
    [[nodiscard]] Interval<T> inside(const Ray<T>& ray, const Interval<T>& within, int face,
                                     bool leaving) const {
        const T ox = ray.origin.x, oy = ray.origin.y, ow = radius(ray.origin.z);
        const T dx = ray.direction.x, dy = ray.direction.y, dw = -slope * ray.direction.z;
        const T A = form(dx, dy, dw);
        if (leaving) {
            const T B = fma(ox, dx, difference_of_products(oy, dy, ow, dw));
            const T other = A != T(0) ? T(-2) * B / A : infinity<T>;
            return between(A, B, T(0), minimum(T(0), other), maximum(T(0), other), dw, within, face);
        }
        const T dd = fma(dx, dx, fma(dy, dy, dw * dw));
        const T start = -fma(ox, dx, fma(oy, dy, ow * dw)) / dd;
        const T x = fma(start, dx, ox), y = fma(start, dy, oy), w = fma(start, dw, ow);
        const T B = fma(x, dx, difference_of_products(y, dy, w, dw));
        const T C = fma(x, x, difference_of_products(y, y, w, w));
        const T m1 = difference_of_products(x, dw, w, dx), m2 = difference_of_products(y, dw, w, dy),
                m3 = difference_of_products(x, dy, y, dx);
        const T D = fma(m1, m1, difference_of_products(m2, m2, m3, m3));
        if (A > T(0) && !(D > T(0))) return Interval<T>::nothing();
        if (A == T(0)) {
            const T root = B != T(0) ? start - C / (T(2) * B) : T(0);
            return between(A, B, C, root, root, dw, within, face);
        }
        const auto [first, second] = quadratic_roots(A, B, C, sqrt(maximum(D, T(0))));
        return between(A, B, C, first + start, second + start, dw, within, face);
    }

    /// The schoolbook's hits with both nappes: hit(t, z) for each.
    template <typename OnHit> void textbook_hits(const Ray<T>& ray, const OnHit& hit) const {
        const Vec3<T>&o = ray.origin, &d = ray.direction;
        const T w = mean - slope * o.z, dw = -slope * d.z;
        const T A = d.x * d.x + d.y * d.y - dw * dw;
        const T B = T(2) * (o.x * d.x + o.y * d.y - w * dw);
        const T C = o.x * o.x + o.y * o.y - w * w;
        const auto at = [&](T t) { hit(t, o.z + t * d.z); };
        if (A == T(0)) { // parallel to a generator
            at(-C / B);
        } else if (const auto roots = textbook_quadratic_roots(A, B, C)) {
            at(roots->first);
            at(roots->second);
        }
    }

    /// Gradient of (x² + y² − w²) / 2.
    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p) const { return {p.x, p.y, slope * radius(p.z)}; }

    /// Second derivative along d of the form, its gradient at p taken as unit.
    [[nodiscard]] T curvature(const Vec3<T>& p, const Vec3<T>& d) const {
        return magnitude(form(d.x, d.y, -slope * d.z)) / length(normal(p));
    }

private:
    [[nodiscard]] static T form(T x, T y, T w) { return fma(x, x, difference_of_products(y, y, w, w)); }

    // The sign of A says on which side of its roots the line is inside.
    [[nodiscard]] static Interval<T> between(T A, T B, T C, T first, T second, T dw,
                                             const Interval<T>& within, int face) {
        Interval<T> wall{-infinity<T>, infinity<T>, face, face};
        if (A > T(0)) {
            wall.enter = first;
            wall.exit = second;
        } else if (A < T(0)) { // steeper than the wall: in by the narrow end or out by it, for good
            if (dw > T(0))
                wall.enter = second;
            else
                wall.exit = first;
        } else if (B > T(0))
            wall.exit = first; // parallel to a generator: a single root
        else if (B < T(0))
            wall.enter = first;
        else if (!(C < T(0)))
            return Interval<T>::nothing();
        return intersection(within, wall);
    }
};

} // namespace rayscope
