#pragma once
// Fresnel's equations: which share of the light a smooth boundary of two media reflects.

#include "core/refraction/snell.hpp"

namespace rayscope {

/// Reflected shares of the energy, 0 … 1, for the two polarizations.
template <Scalar T> struct Reflectance {
    T perpendicular, parallel; ///< Rs and Rp
    [[nodiscard]] T unpolarized() const { return (perpendicular + parallel) / T(2); }
};

/// Of a ray that was bent by `refract`; everything at total internal reflection.
///
/// With n = 1 / c, the schoolbook squares
///     (n₁ cos θ₁ − n₂ cos θ₂) / (n₁ cos θ₁ + n₂ cos θ₂)   and   (n₂ cos θ₁ − n₁ cos θ₂) / (n₂ cos θ₁ + n₁ cos θ₂),
/// whose numerators cancel where the media are alike. Stable: each numerator times its denominator is, by Snell's law,
///     (n₁ − n₂)(n₁ + n₂)   and   (n₂ − n₁)(n₂ + n₁)(cos θ₁ − η sin θ₁)(cos θ₁ + η sin θ₁):
/// only Brewster's angle, where the light itself vanishes, is left to cancel. Relative error: a few ε, of Rp also times
/// cos θ₁ / |cos θ₁ − η sin θ₁|.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Reflectance<T> fresnel(const Refraction<T>& bent, T speed_from, T speed_to) {
    if (bent.total()) return {T(1), T(1)};
    const T n1 = speed_to, n2 = speed_from; // both times c₁ c₂
    const T cos1 = bent.cosine, cos2 = sqrt(bent.radicand);
    const auto square = [](T x) { return x * x; };
    const T s = n1 * cos1 + n2 * cos2, p = n2 * cos1 + n1 * cos2;
    if constexpr (is_textbook<N>)
        return {square((n1 * cos1 - n2 * cos2) / s), square((n2 * cos1 - n1 * cos2) / p)};
    const T contrast = (n1 - n2) * (n1 + n2);
    const T turned = (cos1 - bent.eta * bent.sine) * (cos1 + bent.eta * bent.sine);
    return {square(contrast / s / s), square(contrast / p / p * turned)};
}

/// Schlick's approximation (1994) of the unpolarized share: R₀ + (1 − R₀)(1 − cos θ)⁵ with R₀ that of normal incidence and
/// θ the angle on the side of the larger index. Off by up to a few hundredths, and where the media are nearly alike by
/// up to 1 at grazing angles; nothing between equal ones, everything at total internal reflection.
template <Scalar T> [[nodiscard]] T schlick(const Refraction<T>& bent, T speed_from, T speed_to) {
    if (bent.total()) return T(1);
    if (speed_from == speed_to) return T(0); // no boundary
    const T contrast = (speed_to - speed_from) / (speed_to + speed_from);
    const T r0 = contrast * contrast;
    const T x = T(1) - (speed_from < speed_to ? sqrt(bent.radicand) : bent.cosine);
    const T xx = x * x;
    return r0 + (T(1) - r0) * xx * xx * x;
}

} // namespace rayscope
