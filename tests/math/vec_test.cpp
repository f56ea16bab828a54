#include "core/math/vec.hpp"

#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Scalar, selections_answer_with_the_second_operand_on_a_tie_or_not_a_number) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::signbit(minimum(0.0, -0.0)));
    EXPECT_FALSE(std::signbit(minimum(-0.0, 0.0)));
    EXPECT_TRUE(std::signbit(maximum(0.0, -0.0)));
    EXPECT_EQ(minimum(nan, 1.0), 1.0);
    EXPECT_EQ(maximum(nan, 1.0), 1.0);
    EXPECT_EQ(minimum(1.0, 2.0), 1.0);
    EXPECT_EQ(maximum(1.0, 2.0), 2.0);
    EXPECT_EQ(magnitude(-3.0), 3.0);
    EXPECT_EQ(magnitude(3.0), 3.0);
}

TEST(Scalar, a_difference_of_products_keeps_what_cancels) {
    const double a = 1 + 0x1p-30, b = 1 - 0x1p-30; // a·b = 1 − 2⁻⁶⁰ exactly
    EXPECT_EQ(difference_of_products(a, b, 1.0, 1.0), -0x1p-60);
    EXPECT_EQ(difference_of_products(1.0, 1.0, a, b), 0x1p-60);
    EXPECT_EQ(difference_of_products(3.0, 5.0, 2.0, 7.0), 1.0);
}

TEST(Vec, the_cross_product_is_right_handed) {
    EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
    EXPECT_EQ(cross(Vec3d{0, 1, 0}, Vec3d{0, 0, 1}), (Vec3d{1, 0, 0}));
    EXPECT_EQ(cross(Vec3d{1, 2, 3}, Vec3d{4, 5, 6}), (Vec3d{-3, 6, -3}));
    EXPECT_EQ(dot(Vec3d{1, 2, 3}, Vec3d{4, -5, 6}), 12.0);
}

TEST(Vec, length_neither_underflows_nor_overflows) {
    EXPECT_EQ(length(Vec3d{3, 4, 0}), 5.0);
    EXPECT_EQ(length(Vec3d{0, -3e300, 4e300}), 5e300);
    EXPECT_EQ(length(Vec3d{3e-300, 0, -4e-300}), 5e-300);
    EXPECT_EQ(length(Vec3d{0}), 0.0);
    EXPECT_EQ(length(Vec3d{1, -infinity<double>, 0}), infinity<double>);
}

TEST(Vec, normalized_is_unit_at_every_scale) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d v = random.direction() * random.decade(-300, 300);
        const Vec3d n = normalized(v);
        ASSERT_NEAR(dot(n, n), 1, 4 * epsilon<double>) << hex(v);
        ASSERT_GT(dot(n, v), 0) << hex(v);
        ASSERT_LE(length(cross(n, v)), 4 * epsilon<double> * length(v)) << hex(v);
    }
    EXPECT_EQ(normalized(Vec3d{0}), Vec3d{0});
}

} // namespace
} // namespace rayscope::test
