#include "core/math/quartic.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rayscope::test {
namespace {

// (t − r₀)(t − r₁)(t² + u t + v)
QuarticRoots<double> roots_of(double r0, double r1, double u, double v) {
    const double s = -(r0 + r1), p = r0 * r1;
    return textbook_quartic_roots(s + u, p + s * u + v, p * u + s * v, p * v);
}

TEST(Quartic, finds_roots_that_lie_apart) {
    Random random(41);
    for (int n = 0; n < 2000; ++n) {
        std::array<double, 4> r{};
        for (std::size_t i = 0; i < 4; ++i) r[i] = double(i) * 2 + random.uniform(-0.7, 0.7) - 3;
        const auto found = roots_of(r[2], r[0], -(r[1] + r[3]), r[1] * r[3]);
        ASSERT_EQ(found.count, 4) << n;
        for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(found.items[i], r[i], 1e-9) << n;
    }
}

TEST(Quartic, complex_roots_are_none) {
    const auto two = roots_of(-1, 2, 1, 5);
    ASSERT_EQ(two.count, 2);
    EXPECT_NEAR(two.items[0], -1, 1e-12);
    EXPECT_NEAR(two.items[1], 2, 1e-12);
    EXPECT_EQ(textbook_quartic_roots(0.0, 3.0, 0.0, 2.0).count, 0); // (t² + 1)(t² + 2)
    EXPECT_EQ(textbook_quartic_roots(0.0, -3.0, 0.0, 2.0).count, 4);
    EXPECT_EQ(textbook_quartic_roots(0.0, 0.0, 0.0, 1.0).count, 0);
}

// What it is known for: the digits that a quartic far from 0 spends on its shift are gone.
TEST(Quartic, loses_roots_that_are_far_from_zero) {
    const double far = 1e5;
    const auto found = roots_of(far + 1, far + 2, -(2 * far + 7), (far + 3) * (far + 4));
    bool lost = found.count != 4;
    for (int i = 0; i < found.count; ++i) {
        const double root = found.items[std::size_t(i)] - far;
        lost = lost || std::abs(root - std::round(root)) > 1e-3;
    }
    EXPECT_TRUE(lost);
}

} // namespace
} // namespace rayscope::test
