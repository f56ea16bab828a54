#pragma once
// The elementary operations of every kernel, so that one template serves each scalar type.

#include <bit>
#include <cmath>
#include <concepts>
#include <limits>

namespace rayscope {

/// A real number type that the kernels can be instantiated with.
template <typename T>
concept Scalar = std::floating_point<T>;

/// Distance from 1 to the next representable number; the rounding unit is half of it.
template <Scalar T> inline constexpr T epsilon = std::numeric_limits<T>::epsilon();

template <Scalar T> inline constexpr T infinity = std::numeric_limits<T>::infinity();

// The own selections have one fixed answer for NaN and for ±0 (the second operand), which std::min and the
// vector units of processors do not share.
template <Scalar T> [[nodiscard]] constexpr T select(bool condition, T yes, T no) {
    return condition ? yes : no;
}
template <Scalar T> [[nodiscard]] constexpr T minimum(T a, T b) { return select(a < b, a, b); }
template <Scalar T> [[nodiscard]] constexpr T maximum(T a, T b) { return select(a > b, a, b); }
template <Scalar T> [[nodiscard]] constexpr T magnitude(T a) { return select(a < T(0), -a, a); }

/// a·b − c·d with at most 2 ulp of error, however much cancels (Kahan; proof by Jeannerod, Louvet, Muller 2013).
template <Scalar T> [[nodiscard]] inline T difference_of_products(T a, T b, T c, T d) {
    const T cd = c * d;
    const T rounding_of_cd = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rounding_of_cd;
}

} // namespace rayscope
