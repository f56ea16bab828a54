#pragma once
// Snell's law: sin θ₂ = (c₂ / c₁) sin θ₁, and where it has no solution.

#include "core/math/vec.hpp"

#include <optional>

namespace rayscope {

template <Scalar T> struct Refraction {
    T eta;             ///< speed_to / speed_from = n_from / n_to
    T cosine, sine;    ///< of the angle of incidence
    T radicand;        ///< cos² θ₂; negative at total internal reflection
    Vec3<T> facing;    ///< the unit normal, turned against the ray
    Vec3<T> direction; ///< of the refracted ray, unit; the mirrored one at total internal reflection
    [[nodiscard]] bool total() const { return radicand < T(0); }
    [[nodiscard]] T theta_from() const { return std::atan2(sine, cosine); }
    [[nodiscard]] T theta_to() const { return std::atan2(eta * sine, std::sqrt(radicand)); }
};

/// Angle of incidence beyond which everything is reflected; exists only on the way into a faster medium.
template <Scalar T> [[nodiscard]] std::optional<T> critical_angle(T speed_from, T speed_to) {
    if (!(speed_from < speed_to)) return std::nullopt;
    return std::asin(speed_from / speed_to);
}

/// Bends the direction d at a surface with normal n (of any length, on either side).
///
/// With n against d and cos θ₁ = −n·d the direction is t = η d + (η cos θ₁ − √k) n. The textbook's
/// k = 1 − η² (1 − cos² θ₁) cancels twice near the critical angle and at grazing incidence; here
///     k = cos² θ₁ + (1 − η)(1 + η) sin² θ₁,   sin θ₁ = |d × n|,   1 − η = (c₁ − c₂) / c₁,
/// and since η² cos² θ₁ − k = η² − 1 the factor of n is −(1 − η)(1 + η) / (η cos θ₁ + √k): for η = 1 it is 0 and d comes
/// back unchanged. Error of each component: a few ε · max(1, 1 / √k).
template <Scalar T> [[nodiscard]] Refraction<T> refract(Vec3<T> d, Vec3<T> n, T speed_from, T speed_to) {
    d = normalized(d);
    n = normalized(n);
    T cosine = -dot(n, d);
    if (cosine < T(0)) {
        cosine = -cosine;
        n = -n;
    }
    const T sine = length(cross(d, n));
    if (sine < cosine)
        cosine = std::sqrt((T(1) - sine) * (T(1) + sine)); // near the normal the sine knows more
    const T eta = speed_to / speed_from;
    const T one_minus = (speed_from - speed_to) / speed_from;
    const T one_plus = (speed_from + speed_to) / speed_from;
    const T radicand = std::fma(sine * one_minus, sine * one_plus, cosine * cosine);
    if (radicand < T(0)) return {eta, cosine, sine, radicand, n, d + (T(2) * cosine) * n};
    const T change = one_minus * one_plus;
    const T along_normal = change == T(0) ? T(0) : -change / std::fma(eta, cosine, std::sqrt(radicand));
    return {eta, cosine, sine, radicand, n, eta * d + along_normal * n};
}

} // namespace rayscope
