#pragma once
// The surfaces once more, as polynomials in 113 bits and without a square root: what the kernels are judged by.

#include "core/generics/generic.hpp"

#include <array>

namespace rayscope::test {

using Wide = __float128;
using WideVec = std::array<Wide, 3>;

struct WideRay {
    WideVec origin, direction;

    [[nodiscard]] WideVec at(Wide t) const {
        WideVec p{};
        for (std::size_t i = 0; i < 3; ++i) p[i] = origin[i] + t * direction[i];
        return p;
    }
};

/// The ray in the object space of M, by Cramer's rule.
[[nodiscard]] inline WideRay exact_object_ray(const Mat4d& matrix, const Ray<double>& ray) {
    const auto m = [&](std::size_t row, std::size_t column) { return Wide(matrix[int(column)][int(row)]); };
    const auto cofactor = [&](std::size_t i, std::size_t j) {
        const std::size_t p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
        return m(p, r) * m(q, s) - m(p, s) * m(q, r);
    };
    const Wide det = m(0, 0) * cofactor(0, 0) + m(0, 1) * cofactor(0, 1) + m(0, 2) * cofactor(0, 2);
    WideRay result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const Wide inverse = cofactor(j, i) / det;
            result.origin[i] += inverse * (Wide(ray.origin[int(j)]) - m(j, 3));
            result.direction[i] += inverse * Wide(ray.direction[int(j)]);
        }
    return result;
}

/// A polynomial that is zero on one face of a generic and negative on the solid's side of it.
[[nodiscard]] inline Wide face_value(const Generic<double>& shape, int face, const WideVec& p) {
    const auto& [x, y, z] = p;
    const Wide one = 1;
    if (const auto* sphere = std::get_if<Sphere<double>>(&shape))
        return x * x + y * y + z * z - Wide(sphere->radius) * Wide(sphere->radius);
    if (std::holds_alternative<Plane<double>>(shape)) return z;
    if (std::holds_alternative<Cube<double>>(shape)) {
        const Wide along = p[std::size_t(face / 2)];
        return (face % 2 == 0 ? -along : along) - one;
    }
    if (const auto* torus = std::get_if<Torus<double>>(&shape)) {
        const Wide r = Wide(torus->minor), ring = x * x + y * y, k = ring + z * z + one - r * r;
        return k * k - 4 * ring;
    }
    if (face == 1) return -z - one;
    if (face == 2) return z - one;
    if (std::holds_alternative<Cylinder<double>>(shape)) return x * x + y * y - one;
    const Wide top = Wide(std::get<Cone<double>>(shape).top);
    const Wide w = (one + top) / 2 - (one - top) / 2 * z;
    return x * x + y * y - w * w;
}

[[nodiscard]] inline int faces_of(const Generic<double>& shape) {
    if (std::holds_alternative<Cube<double>>(shape)) return 6;
    if (std::holds_alternative<Cylinder<double>>(shape) || std::holds_alternative<Cone<double>>(shape))
        return 3;
    return 1;
}

/// Is the point inside, every face asked?
[[nodiscard]] inline bool exactly_inside(const Generic<double>& shape, const WideVec& p) {
    for (int face = 0; face < faces_of(shape); ++face)
        if (!(face_value(shape, face, p) < 0)) return false;
    return true;
}

} // namespace rayscope::test
