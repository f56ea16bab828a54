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

/// The largest root of y³ + a y² + b y + c to some two digits, where Newton's kind of step can begin.
template <Scalar T> [[nodiscard]] float rough_largest_root(T a, T b, T c) {
    const T third = a / T(3); // y = x − a/3 makes it x³ + 3 p x + 2 h
    const float p = float(fma(-third, third, b / T(3)));
    const float h = float(fma(third, fma(third, third, b / T(-2)), c / T(2)));
    const float discriminant = h * h + p * p * p;
    // One root: Cardano's.
    const float cube_root = rough_cbrt(magnitude(h) + std::sqrt(maximum(discriminant, 0.0F)));
    const float x = cube_root - p / cube_root;
    // Three: Viète's. cos(acos(t)/3) is ½ + √((1+t)/6) near t = −1, and with one more term nowhere 0.004 off.
    const float m = std::sqrt(maximum(-p, 0.0F));
    const float root = std::sqrt(maximum(1 + h / (p * m), 0.0F));
    const float largest = 2 * m * (0.5F + root * (0.408248F - 0.0387F * root));
    return select(discriminant < 0, largest, select(h < 0, x, -x)) - float(third);
}

/// The largest root y of Ferrari's resolvent y³ + 2p y² + (p² − 4c) y − r², which is u². Only the work is at stake in
/// it, not the result: what it lacks stands in QuarticFactors::error.
template <Scalar T> [[nodiscard]] T squared_sum_of_lower_roots(const DepressedQuartic<T>& f) {
    const T a = T(2) * f.p, b = fma(f.p, f.p, T(-4) * f.c), c = -f.r * f.r;
    T y = maximum(T(0), T(rough_largest_root(a, b, c)));
    // Halley's step: its error is cubed. That y is right to ε is enough, however small it is: see factors_of.
    const auto step = [&] {
        const T v2 = y + a, v1 = fma(v2, y, b);
        const T value = fma(v1, y, c), slope = fma(y + v2, y, v1), bend = fma(T(2), y, v2);
        const T down = value * slope / fma(slope, slope, -value * bend);
        y = maximum(T(0), y - down);
        return magnitude(down);
    };
    step();
    constexpr int enough = 8; // of them; nearly always two
    for (int i = 1; i < enough; ++i) {
        const T last = step();
        if (!(last * last * last > epsilon<T>)) break;
    }
    return y;
}

template <Scalar T> [[nodiscard]] QuarticFactors<T> factors_of(const DepressedQuartic<T>& f) {
    const T y = squared_sum_of_lower_roots(f);
    // (w − v)² = (v + w)² − 4vw and u (w − v) = r: the larger of u and w − v is a root, the other one a quotient.
    const T rough_sum = f.p + y;
    const T difference_squared = fma(rough_sum, rough_sum, T(-4) * f.c);
    const T larger = sqrt(maximum(y, difference_squared));
    const T smaller = magnitude(f.r) / larger;
    const bool sum_is_larger = y > difference_squared;
    const T u = select(sum_is_larger, larger, smaller), size = select(sum_is_larger, smaller, larger);
    const T difference = select(f.r < T(0), -size, size);
    const T sum = fma(u, u, f.p);
    const T v = (sum - difference) / T(2), w = (sum + difference) / T(2);
    const T quarter = u * u / T(4);
    return {u / T(2), quarter - v, quarter - w, f.rounding + magnitude(fma(v, w, -f.c))};
}

/// Whether the quartic, up to the error of its factors, has two crossings for each factor with a positive square and
/// no others. Where |product| > error the sign of the quartic is that of the product.
/// @param low, high the half chords, 0 for a factor without roots
template <Scalar T> [[nodiscard]] bool count_is_proven(const QuarticFactors<T>& factors, T low, T high) {
    const auto& [half_u, below, above, error] = factors;
    const T product = magnitude(below * above);
    // Four crossings: negative at both vertices, positive in the middle of the gap between the pairs.
    const T uu = T(4) * half_u * half_u;
    const T inside = minimum(below * (uu - above), above * (uu - below));
    const T half_gap = half_u - (low + high) / T(2);
    const T between = half_gap * magnitude(half_gap) * (half_gap + T(2) * low) * (half_gap + T(2) * high);
    // Two: one factor q is positive everywhere. A third crossing beside one of the other factor's would be a turn of
    // the quartic there; its slope does not vanish, as q^(3/2) √other > 3 √2 error.
    const T rootless = minimum(below, above);
    const T slope_squared = product * rootless * rootless;
    const bool four = rootless > T(0);
    const T least = select(four, minimum(inside, between), slope_squared);
    const T enough = select(four, error, T(18) * error * error);
    return product > T(2) * error && (low + high == T(0) || least > enough);
}

/// Newton on the distance, for all roots at once: each step waits for a root and a quotient, and they wait together.
/// False unless the last steps were so small that the next ones would be below rounding, and the roots ascend: a step's
/// error is its square over the gap to the nearest other root, and rounding moves a root by ε minor / slope.
/// Two roots are to stand there twice: to a vector unit four are as many as two.
template <Scalar T> [[nodiscard]] bool polish(const TorusLine<T>& line, TorusRoots<T>& roots) {
    const Vec3<T>&q = line.q, &e = line.e;
    auto& items = roots.items;
    const T minor = line.minor;
    const T first = items[1] - items[0], last = items[3] - items[2];
    const T middle = select(roots.count == 4, items[2] - items[1], infinity<T>);
    const std::array<T, 4> gaps{first, minimum(first, middle), minimum(last, middle), last};
    const std::size_t lanes = has_fma<T> ? 4 : std::size_t(roots.count);
    constexpr int enough = 4;
    for (int pass = 0; pass < enough; ++pass) {
        T excess = T(0);
        for (std::size_t i = 0; i < lanes; ++i) {
            const T s = items[i];
            const T x = fma(s, e.x, q.x), y = fma(s, e.y, q.y), z = fma(s, e.z, q.z);
            const T rho = sqrt(fma(x, x, y * y)), beyond = fma(x, x, fma(y, y, T(-1)));
            // value / slope of TorusLine::distance, times ρ (ρ + 1)² above and below.
            const T sum = rho + T(1);
            const T value = fma(beyond, beyond, difference_of_products(z, z, minor, minor) * sum * sum);
            const T slope = fma(beyond, fma(x, e.x, y * e.y), z * e.z * rho * sum) * sum * T(2);
            const T step = value * rho / slope;
            items[i] = s - step;
            const T rounding = epsilon<T> / T(8) * minor * rho * sum * sum * gaps[i];
            excess += maximum(step * step * magnitude(slope) - rounding, T(0)) +
                      maximum(magnitude(step) - gaps[i] / T(4), T(0));
        }
        if (excess == T(0))
            return items[0] < items[1] && items[2] < items[3] && (roots.count == 2 || items[1] < items[2]);
    }
    return false;
}

/// The factors of the quartic, in lengths from line.closest.
template <Scalar T> [[nodiscard]] QuarticFactors<T> factors_of(const TorusLine<T>& line) {
    const auto& [q, e, closest, minor] = line;
    const Vec3<T> m{fma(closest, e.x, q.x), fma(closest, e.y, q.y), fma(closest, e.z, q.z)};
    const T k = fma(T(1) - minor, T(1) + minor, dot(m, m));
    const T A = fma(e.x, e.x, e.y * e.y), B = fma(m.x, e.x, m.y * e.y), C = fma(m.x, m.x, m.y * m.y);
    // Each of some ten roundings is of at most (k + 1)², as |s|² ≤ k + 1 on the torus.
    const T rounding = T(8) * epsilon<T> * (k + T(1)) * (k + T(1));
    return factors_of(DepressedQuartic<T>{T(2) * k - T(4) * A, T(-8) * B, fma(k, k, T(-4) * C), rounding});
}

/// All crossings of the line, or false: then nothing is known.
template <Scalar T>
[[nodiscard]] bool factored_roots(const TorusLine<T>& line, const QuarticFactors<T>& factors,
                                  TorusRoots<T>& roots) {
    const T low = sqrt(maximum(factors.below, T(0))), high = sqrt(maximum(factors.above, T(0)));
    if (!count_is_proven(factors, low, high)) return false;
    if (low + high == T(0)) return true;
    const bool first = low > T(0), last = high > T(0);
    const T left = line.closest - factors.half_u, right = line.closest + factors.half_u;
    const T lower = select(first, left, right), upper = select(last, right, left);
    const T lower_half = select(first, low, high), upper_half = select(last, high, low);
    roots.items = {lower - lower_half, lower + lower_half, upper - upper_half, upper + upper_half};
    roots.count = first && last ? 4 : 2;
    if (polish(line, roots)) return true;
    roots.count = 0;
    return false;
}

} // namespace rayscope
