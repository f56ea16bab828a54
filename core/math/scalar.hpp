#pragma once
// The elementary operations of every kernel, so that one template serves each scalar type.

#include <bit>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>

namespace rayscope {

/// 113 bits of significand, in software: what the other types are measured against.
using Float128 = __float128;

/// A real number type that the kernels can be instantiated with. (In strict ISO mode std::floating_point leaves
/// __float128 out.)
template <typename T>
concept Scalar = std::floating_point<T> || std::same_as<T, Float128>;

// std::numeric_limits knows nothing of __float128: its epsilon() is silently 0.
namespace limits {
template <Scalar T> inline constexpr int digits = std::numeric_limits<T>::digits;
template <> inline constexpr int digits<Float128> = 113;

template <Scalar T> constexpr T power_of_half(int exponent) {
    T power = T(1);
    for (int i = 0; i < exponent; ++i) power /= T(2);
    return power;
}

/// Sums of squares between this and its inverse have lost nothing to the ends of the range.
template <Scalar T> inline constexpr T least_safe_square = power_of_half<T>(digits<T> * 5 / 2);
} // namespace limits

/// Distance from 1 to the next representable number; the rounding unit is half of it.
template <Scalar T> inline constexpr T epsilon = limits::power_of_half<T>(limits::digits<T> - 1);

template <Scalar T> inline constexpr T infinity = T(std::numeric_limits<double>::infinity());

// The own selections have one fixed answer for NaN and for ±0 (the second operand), which std::min and the
// vector units of processors do not share.
template <Scalar T> [[nodiscard]] constexpr T select(bool condition, T yes, T no) {
    return condition ? yes : no;
}
template <Scalar T> [[nodiscard]] constexpr T minimum(T a, T b) { return select(a < b, a, b); }
template <Scalar T> [[nodiscard]] constexpr T maximum(T a, T b) { return select(a > b, a, b); }
/// |a|: of −0 it is 0.
template <Scalar T> [[nodiscard]] constexpr T magnitude(T a) {
    if constexpr (std::floating_point<T>)
        return std::abs(a); // one instruction, where a selection takes five
    else
        return select(a < T(0), -a, a);
}
template <Scalar T> [[nodiscard]] constexpr bool is_finite(T a) { return magnitude(a) < infinity<T>; }

/// True where the processor multiplies and adds with one rounding.
template <Scalar T> inline constexpr bool has_fma = std::same_as<T, float> || std::same_as<T, double>;

/// a·b + c, rounded once in float and double. The wide types round twice: a fused operation is a library call there,
/// 5 to 10 times dearer (350 ns), and no derivation below needs it of them.
template <Scalar T> [[nodiscard]] inline T fma(T a, T b, T c) {
    if constexpr (has_fma<T>)
        return std::fma(a, b, c);
    else
        return a * b + c;
}

template <std::floating_point T> [[nodiscard]] inline T sqrt(T a) { return std::sqrt(a); }
template <std::floating_point T> [[nodiscard]] inline T cbrt(T a) { return std::cbrt(a); }
template <std::floating_point T> [[nodiscard]] inline T cos(T a) { return std::cos(a); }
template <std::floating_point T> [[nodiscard]] inline T acos(T a) { return std::acos(a); }
[[nodiscard]] Float128 sqrt(Float128 a);
[[nodiscard]] Float128 cbrt(Float128 a);
[[nodiscard]] Float128 cos(Float128 a);
[[nodiscard]] Float128 acos(Float128 a);
/// A decimal number, correctly rounded; 0 where the text is none.
[[nodiscard]] Float128 float128_from(const std::string& decimal);

/// What rounding took from the product: a·b − rounded, exactly.
template <Scalar T> [[nodiscard]] inline T product_error(T a, T b, T rounded) {
    if constexpr (has_fma<T>) {
        return std::fma(a, b, -rounded);
    } else { // Dekker 1971, with Veltkamp's splitting into halves whose products are exact
        constexpr T splitter = T(1) / limits::power_of_half<T>((limits::digits<T> + 1) / 2) + T(1);
        const auto high = [](T x) {
            const T shifted = splitter * x;
            return shifted - (shifted - x);
        };
        const T ah = high(a), bh = high(b);
        const T al = a - ah, bl = b - bh;
        return ((ah * bh - rounded) + ah * bl + al * bh) + al * bl;
    }
}

/// a·b − c·d with at most 2 ulp of error, however much cancels (Kahan; proof by Jeannerod, Louvet, Muller 2013).
template <Scalar T> [[nodiscard]] inline T difference_of_products(T a, T b, T c, T d) {
    const T cd = c * d;
    if constexpr (has_fma<T>) {
        const T rounding_of_cd = std::fma(-c, d, cd);
        return std::fma(a, b, -cd) + rounding_of_cd;
    } else {
        const T ab = a * b;
        return (ab - cd) + (product_error(a, b, ab) - product_error(c, d, cd));
    }
}

} // namespace rayscope
