#include "core/reflection/mirror.hpp"

#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Mirror, the_direction_is_mirrored_and_not_the_point) {
    // Plane z = 1, hit at (0, 1.5, 1): mirroring the point would give (0, 1.5, −1), into the plane.
    EXPECT_NEAR(length(mirrored<double>(Vec3d{0, 0.6, -0.8}, Vec3d{0, 0, 1}) - Vec3d{0, 0.6, 0.8}), 0, 1e-16);
    EXPECT_EQ(mirrored<double>(Vec3d{0, 0, -1}, Vec3d{0, 0, 1}), (Vec3d{0, 0, 1}));
    EXPECT_EQ(mirrored<double>(Vec3d{1, 2, 3}, Vec3d{0, 1, 0}), (Vec3d{1, -2, 3}));
}

TEST(Mirror, keeps_length_and_angle_and_is_its_own_inverse) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        Random random(seed);
        const Vec3d d = random.direction() * random.decade(-3, 3), n = normalized(random.direction());
        const Vec3d m = mirrored<double>(d, n);
        const double size = length(d);
        // |n| is 1 within 2ε, and n enters twice: 4 (d·n)² (|n|² − 1) is at most 16ε of |d|², half of it in |m|.
        ASSERT_NEAR(length(m) / size, 1, 8 * epsilon<double>) << hex(d) << hex(n);
        ASSERT_NEAR(dot(m, n) / size, -dot(d, n) / size, 1e-15) << hex(d) << hex(n);
        ASSERT_NEAR(length(cross(m, n) - cross(d, n)) / size, 0, 4e-15) << hex(d) << hex(n);
        ASSERT_NEAR(length(mirrored<double>(m, n) - d) / size, 0, 4e-15) << hex(d) << hex(n);
        ASSERT_EQ(mirrored<double>(d, -n), m) << hex(d) << hex(n);
    }
}

} // namespace
} // namespace rayscope::test
