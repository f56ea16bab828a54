#pragma once
// Snell's law: sin θ₂ = (c₂ / c₁) sin θ₁, and where it has no solution.

#include "core/math/numbers.hpp"
#include "core/math/vec.hpp"

#include <optional>

namespace rayscope {

template <Scalar T> struct Refraction {
    T eta;             ///< speed_to / speed_from = n_from / n_to
    T cosine, sine;    ///< of the angle of incidence
    T radicand;        ///< cos² θ₂; negative at total internal reflection
    Vec3<T> direction; ///< of the refracted ray, unit; without meaning if total()
    [[nodiscard]] bool total() const { return radicand < T(0); }
    /// Of incidence and of refraction, radians.
    [[nodiscard]] double theta_from() const { return std::atan2(double(sine), double(cosine)); }
    [[nodiscard]] double theta_to() const { return std::atan2(double(eta * sine), double(sqrt(radicand))); }
};

/// Angle of incidence beyond which everything is reflected; exists only on the way into a faster medium.
[[nodiscard]] inline std::optional<double> critical_angle(double speed_from, double speed_to) {
    if (!(speed_from < speed_to)) return std::nullopt;
    return std::asin(speed_from / speed_to);
}

/// The schoolbook's t = η (d + cos θ₁ n) − √k n with k = 1 − η² (1 − cos² θ₁), which cancels twice near the critical angle
/// and at grazing incidence. Both vectors unit, n against d.
template <Scalar T>
[[nodiscard]] Refraction<T> textbook_refract(const Vec3<T>& d, const Vec3<T>& n, T speed_from, T speed_to) {
    const T cosine = -dot(n, d);
    const T eta = speed_to / speed_from;
    const T squared_sine = T(1) - cosine * cosine;
    const T radicand = T(1) - eta * eta * squared_sine;
    const T sine = sqrt(maximum(squared_sine, T(0)));
    if (radicand < T(0)) return {eta, cosine, sine, radicand, d};
    return {eta, cosine, sine, radicand, eta * d + (eta * cosine - sqrt(radicand)) * n};
}

/// Bends the direction d at a surface with normal n (of any length, on either side).
///
/// With n against d, the direction is split into its parts along and across the normal, and the part across is scaled:
///     t = η (d + cos θ₁ n) − √k n,   k = cos² θ₂.
/// Stable:
///     k = cos² θ₁ + (1 − η)(1 + η) sin² θ₁,   sin θ₁ = |d × n|,   1 − η = (c₁ − c₂) / c₁,
/// and the part across is n × (d × n), whose digits survive at normal incidence however large η is.
/// Error of each component: a few ε · max(1, 1 / √k). For η = 1 the direction comes back unchanged.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Refraction<T> refract(Vec3<T> d, Vec3<T> n, T speed_from, T speed_to) {
    d = normalized(d);
    n = normalized(n);
    T cosine = -dot(n, d);
    if (cosine < T(0)) {
        cosine = -cosine;
        n = -n;
    }
    if constexpr (is_textbook<N>) return textbook_refract(d, n, speed_from, speed_to);
    const Vec3<T> turn = cross(d, n);
    const T sine = length(turn);
    if (sine < cosine) cosine = sqrt((T(1) - sine) * (T(1) + sine)); // near the normal the sine knows more
    const T eta = speed_to / speed_from;
    const T one_minus = (speed_from - speed_to) / speed_from;
    const T one_plus = (speed_from + speed_to) / speed_from;
    const T radicand = fma(sine * one_minus, sine * one_plus, cosine * cosine);
    if (speed_from == speed_to || radicand < T(0)) return {eta, cosine, sine, radicand, d};
    return {eta, cosine, sine, radicand, eta * cross(n, turn) - sqrt(radicand) * n};
}

extern template Refraction<float> refract<float>(Vec3<float>, Vec3<float>, float, float);
extern template Refraction<double> refract<double>(Vec3<double>, Vec3<double>, double, double);
extern template Refraction<long double> refract<long double>(Vec3<long double>, Vec3<long double>,
                                                             long double, long double);
extern template Refraction<Float128> refract<Float128>(Vec3<Float128>, Vec3<Float128>, Float128, Float128);
extern template Refraction<float> refract<Textbook<float>>(Vec3<float>, Vec3<float>, float, float);
extern template Refraction<double> refract<Textbook<double>>(Vec3<double>, Vec3<double>, double, double);
extern template Refraction<long double> refract<Textbook<long double>>(Vec3<long double>, Vec3<long double>,
                                                                       long double, long double);
extern template Refraction<Float128> refract<Textbook<Float128>>(Vec3<Float128>, Vec3<Float128>, Float128,
                                                                 Float128);

} // namespace rayscope
