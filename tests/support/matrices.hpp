#pragma once
// Matrices for tests: the leftmost factor acts last.

#include "tests/support/random.hpp"

#include <numbers>

namespace rayscope::test {

[[nodiscard]] inline Mat4d translation(const Vec3d& offset) {
    Mat4d m{1};
    m[3] = {offset, 1.0};
    return m;
}

[[nodiscard]] inline Mat4d scaling(double x, double y, double z) {
    Mat4d m{1};
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

[[nodiscard]] inline Mat4d scaling(double s) { return scaling(s, s, s); }

/// Right-handed, about a unit axis (Rodrigues).
[[nodiscard]] inline Mat4d rotation(const Vec3d& axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    Mat4d m{1};
    for (int j = 0; j < 3; ++j) {
        Vec3d e{0};
        e[j] = 1;
        m[j] = {c * e + s * cross(axis, e) + (1 - c) * axis[j] * axis, 0.0};
    }
    return m;
}

/// x grows by `amount` · z.
[[nodiscard]] inline Mat4d shearing(double amount) {
    Mat4d m{1};
    m[2][0] = amount;
    return m;
}

[[nodiscard]] inline Mat4d random_rotation(Random& random) {
    return rotation(random.direction(), random.uniform(0, 360));
}

/// Scaled unevenly, sheared, turned, moved, and mirrored every other time; condition below about 30.
[[nodiscard]] inline Mat4d random_matrix(Random& random) {
    const Mat4d size = scaling(random.uniform(0.3, 2) * (random.coin() ? -1 : 1), random.uniform(0.3, 2),
                               random.uniform(0.3, 2));
    return translation(random.in_cube(3)) * random_rotation(random) * shearing(random.uniform(-0.7, 0.7)) *
           size;
}

[[nodiscard]] inline Vec3d transformed_point(const Mat4d& m, const Vec3d& p) {
    return Vec3d{m * glm::vec<4, double>{p, 1.0}};
}

[[nodiscard]] inline Vec3d transformed_vector(const Mat4d& m, const Vec3d& v) {
    return Vec3d{m * glm::vec<4, double>{v, 0.0}};
}

} // namespace rayscope::test
