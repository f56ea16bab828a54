#pragma once
// The schoolbook's quartic: Ferrari's two squares, with Cardano's root of the resolvent cubic between them.

#include "core/math/roots.hpp"

namespace rayscope {

/// The real roots of a quartic, ascending.
template <Scalar T> struct QuarticRoots {
    std::array<T, 4> items;
    int count = 0;

    void add(T root) {
        int place = count++;
        for (; place > 0 && root < items[std::size_t(place) - 1]; --place)
            items[std::size_t(place)] = items[std::size_t(place) - 1];
        items[std::size_t(place)] = root;
    }
};

/// The largest real root of t³ + a t² + b t + c: Cardano's where it is the only one, else Viète's cosine.
/// The two cube roots cancel where they have opposite signs, and the discriminant where roots are close.
template <Scalar T> [[nodiscard]] T textbook_largest_cubic_root(T a, T b, T c) {
    const T p = b - a * a / T(3);
    const T q = T(2) * a * a * a / T(27) - a * b / T(3) + c;
    const T discriminant = q * q / T(4) + p * p * p / T(27);
    if (discriminant > T(0)) {
        const T root = sqrt(discriminant);
        return cbrt(-q / T(2) + root) + cbrt(-q / T(2) - root) - a / T(3);
    }
    const T radius = T(2) * sqrt(maximum(-p / T(3), T(0)));
    if (!(radius > T(0))) return -a / T(3);
    const T cosine = maximum(T(-1), minimum(T(1), T(3) * q / (p * radius)));
    return radius * cos(acos(cosine) / T(3)) - a / T(3);
}

/// The real roots of t⁴ + a t³ + b t² + c t + d. With t = x − a/4 the cubic term goes, and for the m that makes the
/// right side a square
///     (x² + p/2 + m)² = 2m x² − q x + m² + pm + p²/4 − r
/// falls into two quadratics. Every step cancels for some quartic: p, q, r for roots that are far from 0, q / √m for
/// small m, and double roots vanish. Roots are lost or invented then, one at a time, so the count may be odd.
template <Scalar T> [[nodiscard]] QuarticRoots<T> textbook_quartic_roots(T a, T b, T c, T d) {
    const T p = b - T(3) * a * a / T(8);
    const T q = c - a * b / T(2) + a * a * a / T(8);
    const T r = d - a * c / T(4) + a * a * b / T(16) - T(3) * a * a * a * a / T(256);
    const T shift = a / T(4);
    QuarticRoots<T> roots;
    if (q == T(0)) { // a quadratic in x²
        const auto squares = textbook_quadratic_roots(T(1), p, r);
        if (!squares) return roots;
        for (const T square : {squares->first, squares->second}) {
            if (!(square >= T(0))) continue;
            const T x = sqrt(square);
            roots.add(-x - shift);
            roots.add(x - shift);
        }
        return roots;
    }
    const T m = textbook_largest_cubic_root(p, p * p / T(4) - r, -q * q / T(8));
    if (!(m > T(0))) return roots;
    const T w = sqrt(T(2) * m);
    const T half = q / (T(2) * w);
    for (const auto& pair : {textbook_quadratic_roots(T(1), -w, p / T(2) + m + half),
                             textbook_quadratic_roots(T(1), w, p / T(2) + m - half)}) {
        if (!pair) continue;
        roots.add(pair->first - shift);
        roots.add(pair->second - shift);
    }
    return roots;
}

} // namespace rayscope
