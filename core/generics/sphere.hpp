#pragma once
// The sphere x² + y² + z² = radius². Face 0.

#include "core/generics/spans.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"
#include "core/math/roots.hpp"

namespace rayscope {

/// The generic is the unit sphere. A World also uses the radius, for spheres that no matrix distorts.
template <Numbers N> struct Sphere {
    using T = ScalarOf<N>;

    T radius = T(1);

    static constexpr const char* name = "sphere";
    static constexpr bool solid = true;

    /// What decides is the distance of the line from the centre: with q the point of the line closest to it,
    ///     half chord² = (radius² − |q|²) / |d|².
    /// The schoolbook's b² − 4ac subtracts two numbers of the size of (distance · |d|)²: a sphere at distance 10⁸
    /// loses all its digits there (Haines, Günther, Akenine-Möller, Ray Tracing Gems 2019, ch. 7).
    // Inlined, so that a row of spheres needs no calls.
    [[nodiscard, gnu::always_inline]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        const Vec3<T>& o = ray.origin;
        const Vec3<T>& d = ray.direction;
        const T dd = dot(d, d);
        if constexpr (is_textbook<N>) {
            const auto roots = textbook_quadratic_roots(dd, T(2) * dot(o, d), dot(o, o) - radius * radius);
            return roots ? Intervals<T>({roots->first, roots->second, 0, 0}) : Intervals<T>();
        }
        if (leaving == 0) { // o lies on the sphere: t² |d|² + 2 t o·d = 0
            const T other = T(-2) * dot(o, d) / dd;
            return Intervals<T>({minimum(T(0), other), maximum(T(0), other), 0, 0});
        }
        const T inverse_dd = T(1) / dd;
        const Chord chord = Chord::of(o.x, o.y, o.z, d.x, d.y, d.z, dd, inverse_dd, radius);
        if (!(chord.squared > T(0))) return {};
        const T half = sqrt(chord.squared * inverse_dd);
        Interval<T> inside{chord.middle - half, chord.middle + half, 0, 0};
        const T C = fma(o.x, o.x, fma(o.y, o.y, fma(o.z, o.z, -radius * radius)));
        mend_small_root(inside.enter, inside.exit, half, dd, C);
        return Intervals<T>(inside);
    }

    /// Middle of the chord in t, and half its length squared: not positive where the line misses. In plain numbers, so
    /// that the compiler can run the same arithmetic on many spheres at once.
    struct Chord {
        T squared, middle;

        [[nodiscard, gnu::always_inline]] static Chord of(T ox, T oy, T oz, T dx, T dy, T dz, T dd,
                                                          T inverse_dd, T radius) {
            const T rough = -fma(oz, dz, fma(oy, dy, ox * dx)) * inverse_dd;
            const T qx = fma(rough, dx, ox), qy = fma(rough, dy, oy), qz = fma(rough, dz, oz);
            // Rounding leaves q a little off the closest point: so far, in t.
            const T residual = fma(qz, dz, fma(qy, dy, qx * dx)) * inverse_dd;
            const T qq = fma(qz, qz, fma(qy, qy, qx * qx));
            return {fma(residual * residual, dd, fma(radius, radius, -qq)), rough - residual};
        }
    };

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int /*face*/) const { return p; }
    [[nodiscard]] T value(const Vec3<T>& p) const { return length(p) - radius; }
    [[nodiscard]] T curvature(const Vec3<T>& /*p*/, const Vec3<T>& d, int /*face*/) const {
        return dot(d, d) / radius;
    }
    [[nodiscard]] Box<T> bounds() const { return {Vec3<T>{-radius}, Vec3<T>{radius}}; }

    template <Numbers M> [[nodiscard]] Sphere<M> to() const { return {ScalarOf<M>(radius)}; }
};

} // namespace rayscope
