#pragma once
// The quick way to the torus's crossings: two quadratics, accepted only with a proof that they count right.

#include "core/generics/torus_line.hpp"

namespace rayscope {

/// s⁴ + p s² + r s + c: the torus along a line that is measured from its point closest to the centre. There the
/// cubic term vanishes, and no coefficient is larger than the torus makes it.
template <Scalar T> struct DepressedQuartic {
    T p, r, c;
    T rounding; ///< what rounding has changed it by, at most, where the torus is
};

/// About s⁴ + p s² + r s + c, as (s² + us + v)(s² − us + w) with u ≥ 0: in the first factor lie the lower roots.
template <Scalar T> struct QuarticFactors {
    T half_u;       ///< the factors' vertices are −u/2 and u/2
    T below, above; ///< their (half chord)², negative where a factor has no root
    T error;        ///< of the product as the quartic, at most
};

/// The largest root y of Ferrari's resolvent y³ + 2p y² + (p² − 4c) y − r², which is u². Only the work is at stake in
/// it, not the result: what it lacks stands in QuarticFactors::error.
template <Scalar T> [[nodiscard]] T squared_sum_of_lower_roots(const DepressedQuartic<T>& f) {
    const T a = T(2) * f.p, b = fma(f.p, f.p, T(-4) * f.c), c = -f.r * f.r;
    // With y = x − a/3 and x = 2 m z it is 4 z³ ∓ 3 z = t.
    const T third = a / T(3);
    const T P = fma(-third, a, b);
    const T half_Q = fma(third, fma(third, third, -b / T(2)), c / T(2));
    const T m2 = magnitude(P) / T(3), m = sqrt(m2);
    T x;
    if (P < T(0) && magnitude(half_Q) < m2 * m) {
        // Three roots; the largest z = cos(acos(t)/3) is ½ + 0.408 √(1+t) near t = −1, and with one more term 0.004 off.
        const T root = sqrt(maximum(T(0), T(1) - half_Q / (m2 * m)));
        x = T(2) * m * fma(root, fma(root, T(-0.0387), T(0.408248)), T(0.5));
    } else {
        const T k = cbrt(magnitude(T(2) * half_Q));
        const T size = T(1.324718) * maximum(k, m * T(1.7320508));
        x = half_Q < T(0) ? size : -size;
    }
    T y = maximum(T(0), x - third);
    constexpr int enough = 8;
    for (int i = 0; i < enough; ++i) {
        const T v2 = y + a, v1 = fma(v2, y, b);
        const T value = fma(v1, y, c), slope = fma(y + v2, y, v1), bend = fma(T(2), y, v2);
        // Halley's step: its error is cubed.
        const T step = value * slope / fma(slope, slope, -value * bend);
        y = maximum(T(0), y - step);
        if (!(step * step * magnitude(step) > epsilon<T> * y * y * y)) break;
    }
    return y;
}

template <Scalar T> [[nodiscard]] QuarticFactors<T> factors_of(const DepressedQuartic<T>& f) {
    const T y = squared_sum_of_lower_roots(f);
    // (w − v)² = (v + w)² − 4vw and u (w − v) = r: the larger of u and w − v is a root, the other one a quotient.
    const T rough_sum = f.p + y;
    const T difference_squared = fma(rough_sum, rough_sum, T(-4) * f.c);
    T u, difference;
    if (y > difference_squared) {
        u = sqrt(y);
        difference = f.r / u;
    } else {
        const T size = sqrt(difference_squared);
        difference = f.r < T(0) ? -size : size;
        u = magnitude(f.r) / size;
    }
    const T sum = fma(u, u, f.p);
    const T v = (sum - difference) / T(2), w = (sum + difference) / T(2);
    const T quarter = u * u / T(4);
    return {u / T(2), quarter - v, quarter - w, f.rounding + magnitude(fma(v, w, -f.c))};
}

/// Whether the quartic, up to the error of its factors, has two crossings for each factor with a positive square and
/// no others. Where |product| > error the sign of the quartic is that of the product.
template <Scalar T> [[nodiscard]] bool count_is_proven(const QuarticFactors<T>& factors) {
    const T error = factors.error;
    const T product = magnitude(factors.below * factors.above);
    if (!(product > T(2) * error)) return false;
    if (factors.below < T(0) && factors.above < T(0)) return true;
    if (factors.below > T(0) && factors.above > T(0)) {
        const T low = sqrt(factors.below), high = sqrt(factors.above);
        const T gap = factors.half_u - (low + high) / T(2);
        return gap > T(0) && gap * gap * (gap + T(2) * low) * (gap + T(2) * high) > error;
    }
    // One factor q > 0 everywhere. A third crossing beside one of the other factor's would be a turn of the quartic
    // there; its slope does not vanish, as q^(3/2) √other > error.
    const T rootless = magnitude(minimum(factors.below, factors.above));
    return product * rootless * rootless > T(18) * error * error;
}

/// Newton on the distance, for all roots at once: each step needs a root and a quotient, which then overlap.
/// False unless the last steps were so small that the next ones would be below rounding.
template <int count, Scalar T>
[[nodiscard]] bool polish(const TorusLine<T>& line, std::array<T, 4>& s, const std::array<T, 4>& gaps) {
    const Vec3<T>&q = line.q, &e = line.e;
    const T minor = line.minor;
    constexpr int enough = 4;
    for (int pass = 0; pass < enough; ++pass) {
        bool done = true;
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
            const T x = fma(s[i], e.x, q.x), y = fma(s[i], e.y, q.y), z = fma(s[i], e.z, q.z);
            const T rho = sqrt(fma(x, x, y * y)), beyond = fma(x, x, fma(y, y, T(-1)));
            // value / slope of TorusLine::distance, times ρ (ρ + 1)² above and below.
            const T sum = rho + T(1);
            const T value = fma(beyond, beyond, difference_of_products(z, z, minor, minor) * sum * sum);
            const T slope = fma(beyond, fma(x, e.x, y * e.y), z * e.z * rho * sum) * sum * T(2);
            const T step = value * rho / slope;
            s[i] -= step;
            done &= step * step <= epsilon<T> / T(8) * gaps[i] * (T(1) - minor);
        }
        if (done) return true;
    }
    return false;
}

/// All crossings of the line, or false: then nothing is known.
template <Scalar T> [[nodiscard]] bool factored_roots(const TorusLine<T>& line, TorusRoots<T>& roots) {
    const auto& [q, e, closest, minor] = line;
    const Vec3<T> m{fma(closest, e.x, q.x), fma(closest, e.y, q.y), fma(closest, e.z, q.z)};
    const T k = fma(T(1) - minor, T(1) + minor, dot(m, m));
    const T A = fma(e.x, e.x, e.y * e.y), B = fma(m.x, e.x, m.y * e.y), C = fma(m.x, m.x, m.y * m.y);
    // Each of some ten roundings is of at most (k + 1)², as |s|² ≤ k + 1 on the torus.
    const T rounding = T(8) * epsilon<T> * (k + T(1)) * (k + T(1));
    const QuarticFactors<T> factors =
        factors_of(DepressedQuartic<T>{T(2) * k - T(4) * A, T(-8) * B, fma(k, k, T(-4) * C), rounding});
    if (!count_is_proven(factors)) return false;
    std::array<T, 4> s{}, gaps{};
    std::size_t count = 0;
    if (factors.below > T(0)) {
        const T half = sqrt(factors.below), middle = closest - factors.half_u;
        s = {middle - half, middle + half};
        gaps = {half, half};
        count = 2;
    }
    if (factors.above > T(0)) {
        const T half = sqrt(factors.above), middle = closest + factors.half_u;
        s[count] = middle - half;
        s[count + 1] = middle + half;
        gaps[count] = gaps[count + 1] = half;
        count += 2;
    }
    if (count == 2 && !(polish<2>(line, s, gaps) && s[0] < s[1])) return false;
    if (count == 4) {
        gaps[1] = minimum(gaps[1], s[2] - s[1]);
        gaps[2] = minimum(gaps[2], s[2] - s[1]);
        if (!(polish<4>(line, s, gaps) && s[0] < s[1] && s[1] < s[2] && s[2] < s[3])) return false;
    }
    roots.items = s;
    roots.count = int(count);
    return true;
}

} // namespace rayscope
