#pragma once
// Vectors, matrices and colours: GLM's, with the few operations that must round in a known way.

#include "core/math/scalar.hpp"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rayscope {

template <Scalar T> using Vec3 = glm::vec<3, T>;
template <Scalar T> using Mat3 = glm::mat<3, 3, T>;
template <Scalar T> using Mat4 = glm::mat<4, 4, T>;

using Vec3d = Vec3<double>;
using Mat4d = Mat4<double>;

/// Linear RGB, unbounded.
using Colour = Vec3d;

/// a·b, fused from x to z: the same bits in every build.
template <Scalar T> [[nodiscard, gnu::always_inline]] inline T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}

/// a × b, each component within 2 ulp.
template <Scalar T>
[[nodiscard, gnu::always_inline]] inline Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

template <Scalar T> [[nodiscard]] inline Vec3<T> absolute(const Vec3<T>& v) {
    return {magnitude(v.x), magnitude(v.y), magnitude(v.z)};
}

template <Scalar T> [[nodiscard]] inline T largest_component(const Vec3<T>& v) {
    return maximum(maximum(v.x, v.y), v.z);
}

/// Component by component.
template <Scalar T> [[nodiscard]] inline Vec3<T> maximum_of(const Vec3<T>& a, const Vec3<T>& b) {
    return {maximum(a.x, b.x), maximum(a.y, b.y), maximum(a.z, b.z)};
}

/// True where a sum of squares has lost nothing to the ends of the number range.
template <Scalar T> [[nodiscard]] inline bool is_safe_square(T square) {
    constexpr T least = limits::least_safe_square<T>;
    return square > least && square < T(1) / least;
}

/// |v|. Where its square would under- or overflow, scaled by the largest component.
template <Scalar T> [[nodiscard]] inline T length(const Vec3<T>& v) {
    if (const T square = dot(v, v); is_safe_square(square)) return sqrt(square);
    const T scale = largest_component(absolute(v));
    if (!(scale > T(0)) || !(scale < infinity<T>)) return scale;
    const Vec3<T> w = v / scale;
    return scale * sqrt(dot(w, w));
}

/// v in another number type, each component rounded.
template <Scalar To, Scalar From> [[nodiscard]] inline Vec3<To> as(const Vec3<From>& v) {
    return {To(v.x), To(v.y), To(v.z)};
}

/// v / |v|; the zero vector stays zero, and a vector that is unit as far as rounding can tell stays what it is.
template <Scalar T> [[nodiscard]] inline Vec3<T> normalized(const Vec3<T>& v) {
    const T square = dot(v, v);
    if (magnitude(square - T(1)) <= T(4) * epsilon<T>) return v;
    if (is_safe_square(square)) return v / sqrt(square);
    const T scale = largest_component(absolute(v));
    if (!(scale > T(0))) return v;
    const Vec3<T> w = v / scale;
    return w / sqrt(dot(w, w));
}

/// Some unit vector at right angles to the unit vector w: the cross product with the axis that lies farthest from it.
template <Scalar T> [[nodiscard]] inline Vec3<T> across(const Vec3<T>& w) {
    const Vec3<T> a = absolute(w);
    Vec3<T> axis{0};
    axis[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = T(1);
    return normalized(cross(axis, w));
}

} // namespace rayscope
