#pragma once
// Local light as formulas: what one light adds at one point. All vectors unit, all in world space.

#include "core/math/vec.hpp"

namespace rayscope {

/// x^n for 0 ≤ x ≤ 1 and n ≥ 0, in the same bits on every machine: libm's pow differs between processors.
/// The whole part of n by squaring, its fraction as 2^(fraction · log₂ x), to 10⁻¹³ of the result.
[[nodiscard]] double phong_power(double x, double n);

/// Lambert: max(0, n·l).
[[nodiscard]] inline double diffuse_share(double cosine) { return maximum(0.0, cosine); }

/// Phong: max(0, r·v)^shininess, with r the light's direction mirrored at the normal and v the way to the eye;
/// nothing if the light is behind the surface.
[[nodiscard]] inline double specular_share(double cosine, double mirror_cosine, double shininess) {
    if (!(cosine > 0) || !(mirror_cosine > 0)) return 0;
    return phong_power(minimum(mirror_cosine, 1.0), shininess);
}

/// r·v for the unit vectors to the light, of the normal, and of the ray (v = −ray).
template <Scalar T>
[[nodiscard]] T mirror_cosine(const Vec3<T>& to_light, const Vec3<T>& normal, const Vec3<T>& ray) {
    const Vec3<T> mirrored = T(2) * dot(normal, to_light) * normal - to_light;
    return -dot(mirrored, ray);
}

} // namespace rayscope
