#pragma once
// The schoolbook's torus: the quartic in t, multiplied out.

#include "core/generics/paired_hits.hpp"
#include "core/math/quartic.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

/// With |o + t d|² + 1 − minor² = dd t² + 2 od t + k the torus is
///     (dd t² + 2 od t + k)² − 4 ((o_x + t d_x)² + (o_y + t d_y)²) = 0.
/// Its coefficients grow like the fourth power of the distance, and what they say of the torus is what is left of
/// their digits: from 10⁴ away nothing is, in double.
template <Scalar T> [[nodiscard]] Intervals<T> torus_textbook(T minor, const Ray<T>& ray) {
    const Vec3<T>& o = ray.origin;
    const Vec3<T>& d = ray.direction;
    const T dd = dot(d, d), od = dot(o, d);
    const T k = dot(o, o) + T(1) - minor * minor;
    const T A = d.x * d.x + d.y * d.y, B = o.x * d.x + o.y * d.y, C = o.x * o.x + o.y * o.y;
    const T scale = T(1) / (dd * dd);
    const QuarticRoots<T> roots =
        textbook_quartic_roots(T(4) * dd * od * scale, (T(4) * od * od + T(2) * dd * k - T(4) * A) * scale,
                               (T(4) * od * k - T(8) * B) * scale, (k * k - T(4) * C) * scale);
    PairedHits<T> hits;
    for (int i = 0; i < roots.count; ++i) hits.add(roots.items[std::size_t(i)], 0);
    return hits.intervals();
}

extern template Intervals<float> torus_textbook(float, const Ray<float>&);
extern template Intervals<double> torus_textbook(double, const Ray<double>&);
extern template Intervals<long double> torus_textbook(long double, const Ray<long double>&);
extern template Intervals<Float128> torus_textbook(Float128, const Ray<Float128>&);

} // namespace rayscope
