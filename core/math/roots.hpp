#pragma once
// Roots that keep their digits: quadratics, and bracketed Newton for everything else.

#include "core/math/scalar.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace rayscope {

/// Both roots, ascending, of A t² + 2 B t + C with A ≠ 0, given √(B² − AC).
/// Only terms of equal sign are added; the other root follows from the product C / A.
template <Scalar T> [[nodiscard]] std::pair<T, T> quadratic_roots(T A, T B, T C, T root_of_discriminant) {
    const T q = B > T(0) ? -(B + root_of_discriminant) : root_of_discriminant - B;
    const T first = q / A;
    const T second = q != T(0) ? C / q : first;
    return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// The schoolbook's roots of A t² + B t + C, ascending, or nothing. B² − 4AC cancels, and so does −B ± √.
template <Scalar T> [[nodiscard]] std::optional<std::pair<T, T>> textbook_quadratic_roots(T A, T B, T C) {
    const T discriminant = B * B - T(4) * A * C;
    if (!(discriminant > T(0))) return std::nullopt;
    const T root = sqrt(discriminant);
    const T first = (-B - root) / (T(2) * A), second = (-B + root) / (T(2) * A);
    return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// Where one root of A t² + 2 B t + C is small beside the distance of the two, as for a ray that starts near a surface,
/// middle ± half has cancelled in it. It follows without cancellation from the other one: their product is C / A.
template <Scalar T> inline void mend_small_root(T& first, T& second, T half, T A, T C) {
    if (magnitude(first) < half / T(2))
        first = C / (A * second);
    else if (magnitude(second) < half / T(2))
        second = C / (A * first);
}

/// The cube root of a positive a, 10⁻⁴ of it off: a third of the exponent, which the bits hold as if they were a
/// logarithm, and one step of Halley's.
[[nodiscard]] inline float rough_cbrt(float a) {
    const float guess = std::bit_cast<float>(std::bit_cast<std::uint32_t>(a) / 3 + 0x2a5137a0U);
    const float cube = guess * guess * guess;
    return guess * (cube + 2 * a) / (2 * cube + a);
}

/// A function's value and derivative at one point.
template <Scalar T> struct Jet {
    T value, slope;
};

/// The root of f in [low, high], where f has opposite signs at the ends: Newton's steps, but bisection wherever one
/// would leave the bracket, so it ends for every f. `negative_at_low` is the sign of f(low).
/// Stops when a step is below `precision` · |t| or the bracket holds no other number.
template <Scalar T, typename F>
[[nodiscard]] T bracketed_root(const F& f, T low, T high, bool negative_at_low, T precision, T start) {
    constexpr int enough = 200; // bisection alone needs 64 + the exponents' range of any real scene
    T t = start;
    for (int i = 0; i < enough; ++i) {
        const Jet<T> at = f(t);
        if (at.value == T(0)) return t;
        ((at.value < T(0)) == negative_at_low ? low : high) = t;
        T next = t - at.value / at.slope;
        if (!(low < next && next < high)) next = low + (high - low) / T(2);
        if (magnitude(next - t) <= precision * magnitude(next)) return next;
        t = next;
    }
    return t;
}

/// Value and slope of the cubic c[0] + c[1] t + c[2] t² + c[3] t³.
template <Scalar T> [[nodiscard]] Jet<T> cubic(const std::array<T, 4>& c, T t) {
    const T v2 = fma(c[3], t, c[2]), v1 = fma(v2, t, c[1]);
    return {fma(v1, t, c[0]), fma(fma(c[3], t, v2), t, v1)};
}

/// The places in (low, high) where the cubic changes sign, ascending; at most three. They are as precise as their
/// use needs: where a quartic turns, an error of √ε moves its value by ε only.
template <Scalar T> struct CubicRoots {
    std::array<T, 3> items;
    int count = 0;
};
template <Scalar T> [[nodiscard]] CubicRoots<T> cubic_sign_changes(const std::array<T, 4>& c, T low, T high) {
    const T precision = sqrt(epsilon<T>) / T(8);
    // Where the cubic itself turns: 3 c₃ t² + 2 c₂ t + c₁ = 0.
    std::array<T, 3> ends{high, high, high};
    const T discriminant = difference_of_products(c[2], c[2], T(3) * c[3], c[1]);
    int pieces = 1;
    if (discriminant > T(0) && c[3] != T(0)) {
        const auto [first, second] = quadratic_roots(T(3) * c[3], c[2], c[1], sqrt(discriminant));
        pieces = 0;
        if (low < first && first < high) ends[std::size_t(pieces++)] = first;
        if (low < second && second < high) ends[std::size_t(pieces++)] = second;
        ends[std::size_t(pieces++)] = high;
    }
    CubicRoots<T> roots;
    T from = low;
    bool negative = cubic(c, low).value < T(0);
    for (int i = 0; i < pieces; ++i) {
        const T to = ends[std::size_t(i)];
        const bool negative_at_end = cubic(c, to).value < T(0);
        if (negative != negative_at_end)
            roots.items[std::size_t(roots.count++)] = bracketed_root(
                [&](T t) { return cubic(c, t); }, from, to, negative, precision, from + (to - from) / T(2));
        from = to;
        negative = negative_at_end;
    }
    return roots;
}

} // namespace rayscope
