#pragma once
// A line, measured from near the torus: what both ways to its crossings share.

#include "core/generics/slab.hpp"
#include "core/math/roots.hpp"
#include "core/math/vec.hpp"

namespace rayscope {

/// ρ − 1 without cancellation, where ρ² = x² + y².
template <Scalar T> [[nodiscard]] T beyond_core_circle(T x, T y, T rho) {
    return fma(x, x, fma(y, y, T(-1))) / (rho + T(1));
}

/// Crossings with a torus, ascending, as lengths along its line.
template <Scalar T> struct TorusRoots {
    std::array<T, 4> items{};
    int count = 0;

    void add(T root) { items[std::size_t(count++)] = root; }
};

/// The points q + s·e with e unit and q, up to rounding, the one closest to the centre: s is a length.
template <Scalar T> struct TorusLine {
    Vec3<T> q, e;
    T closest; ///< the s that is closest to the centre: rounding leaves q a little beside it
    T minor;

    /// (ρ − 1)² + z² − minor²: the quartic's sign without its cancellation, since ρ − 1 = (ρ² − 1) / (ρ + 1).
    [[nodiscard]] Jet<T> distance(T s) const {
        const T x = fma(s, e.x, q.x), y = fma(s, e.y, q.y), z = fma(s, e.z, q.z);
        const T rho = sqrt(fma(x, x, y * y));
        const T w = beyond_core_circle(x, y, rho);
        const T rho_slope = rho > T(0) ? fma(x, e.x, y * e.y) / rho : T(0);
        return {fma(w, w, difference_of_products(z, z, minor, minor)), T(2) * fma(w, rho_slope, z * e.z)};
    }

    /// The quartic (|p|² + 1 − minor²)² − 4ρ² as a product, of the distance and the same with −ρ for ρ.
    [[nodiscard]] T quartic(T s) const {
        const T x = fma(s, e.x, q.x), y = fma(s, e.y, q.y), z = fma(s, e.z, q.z);
        const T rho = sqrt(fma(x, x, y * y));
        const T w = beyond_core_circle(x, y, rho), height = difference_of_products(z, z, minor, minor);
        return fma(w, w, height) * fma(rho + T(1), rho + T(1), height);
    }

    /// The part in the sphere and in the slab |z| ≤ minor, each a little larger than the torus.
    [[nodiscard]] Interval<T> around(T half_chord) const {
        const T half = half_chord + margin();
        const T thickness = minor + margin();
        return intersection(Interval<T>{closest - half, closest + half, 0, 0},
                            slab(q.z / thickness, e.z / thickness, 0, 0, no_face));
    }

    /// True if `around` is empty, most often, or lies within the hole: ρ² is convex along it.
    [[nodiscard]] bool surely_misses(T half_chord) const {
        const T z = fma(closest, e.z, q.z), thickness = minor + margin();
        if (magnitude(z) - (half_chord + margin()) * magnitude(e.z) > thickness) return true;
        const T inverse =
            T(1) / e.z; // infinite where the line keeps its height, which then is not in the hole
        const auto radius_squared = [&](T height) {
            const T s = (height - q.z) * inverse;
            const T x = fma(s, e.x, q.x), y = fma(s, e.y, q.y);
            return fma(x, x, y * y);
        };
        const T low = radius_squared(-thickness), high = radius_squared(thickness);
        const T hole = (T(1) - minor) * (T(1) - T(8) * epsilon<T>);
        return low < hole * hole && high < hole * hole;
    }

private:
    [[nodiscard]] T margin() const { return minor / T(64); }
};

} // namespace rayscope
