#pragma once
// A line that grazes the torus: one of its factors can't tell two roots from none, and the distance has to.

#include "core/generics/torus_factors.hpp"

namespace rayscope {

/// (s − vertex)² − square
template <Scalar T> struct Parabola {
    T vertex, square;
};

/// The factors, told apart by what is to be asked of them.
template <Scalar T> struct GrazingFactors {
    Parabola<T> graze; ///< with roots that nearly meet, or nearly exist
    Parabola<T> other;
};

template <Scalar T> [[nodiscard]] GrazingFactors<T> grazing_factors(const QuarticFactors<T>& factors) {
    const auto& [half_u, below, above, error] = factors;
    if (below > T(0) && above > T(0)) {
        const T low = sqrt(below), high = sqrt(above), gap = T(2) * half_u - (low + high);
        if (gap < minimum(low, high)) { // it is the inner two that meet, across the pairs
            const T vertex = (low - high) / T(2), wide = half_u + (low + high) / T(2);
            return {{vertex, gap * gap / T(4)}, {-vertex, wide * wide}};
        }
    }
    const Parabola<T> lower{-half_u, below}, upper{half_u, above};
    return magnitude(below) < magnitude(above) ? GrazingFactors<T>{lower, upper}
                                               : GrazingFactors<T>{upper, lower};
}

/// Whether the quartic turns once, by rounding beside its vertex, where the graze is, and the other factor's roots are
/// what they seem. With Q the other factor at the vertex: the quartic's second derivative there, 2Q, keeps its sign as
/// far as h, for |Q′| is at most `steep`; from h on the graze's factor is above h²/2, which leaves for the other one an
/// error of 2 error / h², with a slope of less than 4 error / h³.
template <Scalar T> [[nodiscard]] bool turns_once(const GrazingFactors<T>& factors, T Q, T error) {
    const auto& [graze, other] = factors;
    const T steep = T(2) * magnitude(graze.vertex - other.vertex);
    const T h = magnitude(Q) / (T(4) * (steep + T(1) + magnitude(Q)));
    const T hh = h * h;
    return magnitude(graze.square) < hh / T(2) &&
           error < hh * minimum(T(1), magnitude(other.square) / T(4)) &&
           (other.square < T(0) || other.square * hh * hh * hh > T(16) * error * error);
}

/// All crossings of a line that grazes in one place, or false.
///
/// Beside the graze's vertex the quartic is Q ((s − vertex)² − square), so its value there, taken from the distance
/// without cancellation, is −Q square: more digits than the factors had, and the sign that decides.
template <Scalar T>
[[nodiscard]] bool grazing_roots(const TorusLine<T>& line, const QuarticFactors<T>& factors,
                                 TorusRoots<T>& roots) {
    GrazingFactors<T> pair = grazing_factors(factors);
    auto& [graze, other] = pair;
    const T apart = graze.vertex - other.vertex;
    const T Q = apart * apart - other.square;
    if (!turns_once(pair, Q, factors.error)) return false;
    graze.vertex += line.closest;
    other.vertex += line.closest;
    graze.square = -line.quartic(graze.vertex) / Q;
    const T near = sqrt(maximum(graze.square, T(0))), far = sqrt(maximum(other.square, T(0)));
    if (near + far == T(0)) return true;
    const std::array<T, 2> inner{graze.vertex - near, graze.vertex + near},
        outer{other.vertex - far, other.vertex + far};
    if (!(near > T(0)))
        roots.items = {outer[0], outer[1], outer[0], outer[1]};
    else if (!(far > T(0)))
        roots.items = {inner[0], inner[1], inner[0], inner[1]};
    else if (Q < T(0))
        roots.items = {outer[0], inner[0], inner[1], outer[1]};
    else if (apart < T(0))
        roots.items = {inner[0], inner[1], outer[0], outer[1]};
    else
        roots.items = {outer[0], outer[1], inner[0], inner[1]};
    roots.count = near > T(0) && far > T(0) ? 4 : 2;
    if (polish(line, roots)) return true;
    roots.count = 0;
    return false;
}

} // namespace rayscope
