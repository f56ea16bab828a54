#pragma once
// The cone with apex (0, 0, 1) and base radius 1 at z = −1, capped; or, truncated, with radius `top` at z = 1.
// Faces: 0 the wall, 1 the base, 2 the top.

#include "core/generics/paired_hits.hpp"
#include "core/generics/slab.hpp"
#include "core/generics/tube.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"

namespace rayscope {

template <Numbers N> struct Cone {
    using T = ScalarOf<N>;

    T top = T(0); ///< radius at z = 1; 0 ≤ top < 1

    static constexpr const char* name = "cone";
    static constexpr bool solid = true;
    static constexpr int wall = 0, base = 1, lid = 2;

    /// Slab first: between its planes the other nappe does not exist.
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if constexpr (is_textbook<N>) return textbook_intervals(ray);
        const Interval<T> within = slab(ray.origin.z, ray.direction.z, base, lid, leaving);
        if (within.empty()) return {};
        return Intervals<T>(ConeWall<T>(top).inside(ray, within, wall, leaving == wall));
    }

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int face) const {
        if (face == base) return {T(0), T(0), T(-1)};
        if (face == lid) return {T(0), T(0), T(1)};
        const Vec3<T> n = ConeWall<T>(top).normal(p);
        return length(n) > T(0) ? n : Vec3<T>{T(0), T(0), T(1)}; // the apex has no normal: the axis stands in
    }
    [[nodiscard]] T value(const Vec3<T>& p) const {
        const ConeWall<T> w(top);
        const T cosine = T(1) / sqrt(fma(w.slope, w.slope, T(1)));
        return maximum((sqrt(fma(p.x, p.x, p.y * p.y)) - w.radius(p.z)) * cosine, magnitude(p.z) - T(1));
    }
    [[nodiscard]] T curvature(const Vec3<T>& p, const Vec3<T>& d, int face) const {
        return face == wall ? ConeWall<T>(top).curvature(p, d) : T(0);
    }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{T(-1)}, Vec3<T>{T(1)}}; }

    template <Numbers M> [[nodiscard]] Cone<M> to() const { return {ScalarOf<M>(top)}; }

private:
    // Both nappes of the wall; z says which hits count. Then the caps.
    [[nodiscard]] Intervals<T> textbook_intervals(const Ray<T>& ray) const {
        PairedHits<T> hits;
        ConeWall<T>(top).textbook_hits(ray, [&](T t, T z) {
            if (magnitude(z) <= T(1)) hits.add(t, wall);
        });
        textbook_cap_hits(ray, T(-1), T(1), [&](T t) { hits.add(t, base); });
        if (top > T(0)) textbook_cap_hits(ray, T(1), top, [&](T t) { hits.add(t, lid); });
        return hits.intervals();
    }
};

} // namespace rayscope
