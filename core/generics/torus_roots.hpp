#pragma once
// Where a ray crosses the torus with major radius 1 around the z axis.

#include "core/generics/torus_graze.hpp"
#include "core/generics/torus_isolation.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

/// Up to four crossings, ascending in t.
///
/// Measured in s, a length, from the point q of the line closest to the centre, and cut by the sphere and the slab
/// around the torus, all has the size of the torus, wherever the ray comes from. There the factors mostly do; where
/// rounding leaves their count in doubt, a graze within about ε, the crossings are isolated.
template <Scalar T> [[nodiscard]] TorusRoots<T> torus_roots(T minor, const Ray<T>& ray) {
    const Vec3<T>& d = ray.direction;
    const T dd = dot(d, d);
    const T middle = -dot(ray.origin, d) / dd;
    const Vec3<T> q = ray.at(middle);
    const T outer = T(1) + minor;
    const T beside = dot(q, d) / dd; // rounding leaves q so far beside the closest point, in t
    const T reach_squared = fma(beside * beside, dd, outer * outer - dot(q, q));
    if (!(reach_squared > T(-8) * epsilon<T>)) return {};
    const T speed = sqrt(dd);
    const TorusLine<T> line{q, d / speed, -beside * speed, minor};
    const T half_chord = sqrt(maximum(reach_squared, T(0)));
    if (line.surely_misses(half_chord)) return {};
    TorusRoots<T> roots;
    const QuarticFactors<T> factors = factors_of(line);
    if (!factored_roots(line, factors, roots) && !grazing_roots(line, factors, roots))
        roots = isolated_roots(line, line.around(half_chord));
    for (T& root : roots.items) root = root / speed + middle;
    return roots;
}

extern template TorusRoots<float> torus_roots(float, const Ray<float>&);
extern template TorusRoots<double> torus_roots(double, const Ray<double>&);
extern template TorusRoots<long double> torus_roots(long double, const Ray<long double>&);
extern template TorusRoots<Float128> torus_roots(Float128, const Ray<Float128>&);

} // namespace rayscope
