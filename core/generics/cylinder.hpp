#pragma once
// The cylinder x² + y² ≤ 1, |z| ≤ 1, with its caps. Faces: 0 the wall, 1 the cap z = −1, 2 the cap z = 1.

#include "core/generics/paired_hits.hpp"
#include "core/generics/slab.hpp"
#include "core/generics/tube.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"

namespace rayscope {

template <Numbers N> struct Cylinder {
    using T = ScalarOf<N>;

    static constexpr const char* name = "cylinder";
    static constexpr bool solid = true;
    static constexpr int wall = 0, bottom = 1, top = 2;

    /// Wall ∩ slab. Whether a cap is hit is never asked as "is this point within the circle?": at the rim both that
    /// test and the wall's could say yes, or both no, and the count of crossings would be odd.
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if constexpr (is_textbook<N>) return textbook_intervals(ray);
        const Interval<T> inside = inside_cylinder_wall(ray, wall, leaving == wall);
        if (inside.empty()) return {};
        return Intervals<T>(intersection(inside, slab(ray.origin.z, ray.direction.z, bottom, top, leaving)));
    }

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int face) const {
        if (face == wall) return {p.x, p.y, T(0)};
        return {T(0), T(0), face == top ? T(1) : T(-1)};
    }
    [[nodiscard]] T value(const Vec3<T>& p) const {
        return maximum(sqrt(fma(p.x, p.x, p.y * p.y)), magnitude(p.z)) - T(1);
    }
    [[nodiscard]] T curvature(const Vec3<T>& /*p*/, const Vec3<T>& d, int face) const {
        return face == wall ? fma(d.x, d.x, d.y * d.y) : T(0);
    }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{T(-1)}, Vec3<T>{T(1)}}; }

    template <Numbers M> [[nodiscard]] Cylinder<M> to() const { return {}; }

private:
    // Wall and caps one after the other, each hit asked whether it lies on its face.
    [[nodiscard]] static Intervals<T> textbook_intervals(const Ray<T>& ray) {
        PairedHits<T> hits;
        textbook_wall_hits(ray, [&](T t, T z) {
            if (magnitude(z) <= T(1)) hits.add(t, wall);
        });
        textbook_cap_hits(ray, T(-1), T(1), [&](T t) { hits.add(t, bottom); });
        textbook_cap_hits(ray, T(1), T(1), [&](T t) { hits.add(t, top); });
        return hits.intervals();
    }
};

} // namespace rayscope
