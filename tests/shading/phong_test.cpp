#include "core/shading/phong.hpp"

#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Phong, the_power_agrees_with_the_library) {
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        Random random(seed);
        const double x = random.uniform(0.01, 1),
                     n = random.coin() ? random.below(200) : random.uniform(0, 200);
        const double exact = std::pow(x, n);
        ASSERT_NEAR(phong_power(x, n), exact, exact * 1e-13) << hex(x) << ' ' << hex(n);
    }
    EXPECT_EQ(phong_power(0.5, 10), 0x1p-10);
    EXPECT_EQ(phong_power(0.25, 1.5), 0.125);
    EXPECT_EQ(phong_power(0.5, 0), 1);
    EXPECT_EQ(phong_power(0, 0), 1);
    EXPECT_EQ(phong_power(0, 3), 0);
    EXPECT_EQ(phong_power(0, 0.5), 0);
    EXPECT_EQ(phong_power(1, 7.25), 1);
    EXPECT_EQ(phong_power(1, 1e300), 1);
    EXPECT_EQ(phong_power(0.5, 1e300), 0);
    EXPECT_EQ(phong_power(1 - 0x1p-53, 0x1p63), 0);
}

TEST(Phong, light_from_behind_adds_nothing) {
    EXPECT_EQ(diffuse_share(0.25), 0.25);
    EXPECT_EQ(diffuse_share(-0.25), 0);
    EXPECT_EQ(specular_share(0.5, 0.5, 2), 0.25);
    EXPECT_EQ(specular_share(-0.5, 0.5, 2), 0);
    EXPECT_EQ(specular_share(0, 0.5, 2), 0);
    EXPECT_EQ(specular_share(0.5, -0.5, 2), 0);
    EXPECT_EQ(specular_share(0.5, 0, 0), 0);
    EXPECT_EQ(specular_share(0.5, 1 + 1e-15, 1e18), 1) << "a cosine that rounding made larger than 1";
}

TEST(Phong, the_mirrored_light_is_compared_with_the_way_to_the_eye) {
    // Straight above, light at 60° from the normal towards +y, the eye where the mirrored light goes.
    const Vec3d l{0, 0.8, 0.6}, n{0, 0, 1};
    EXPECT_DOUBLE_EQ(mirror_cosine(l, n, {0, 0.8, -0.6}), 1); // the ray comes from −y
    EXPECT_DOUBLE_EQ(mirror_cosine(l, n, {0, 0, -1}), 0.6);
    EXPECT_DOUBLE_EQ(mirror_cosine(l, n, {0, -0.8, -0.6}), -0.64 + 0.36);
}

} // namespace
} // namespace rayscope::test
