#include "core/math/roots.hpp"

#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// Of A (t − first)(t − second), with its exact discriminant.
std::pair<double, double> roots_of(double A, double first, double second) {
    const double B = -A * (first + second) / 2, C = A * first * second;
    return quadratic_roots(A, B, C, std::abs(A) * std::abs(second - first) / 2);
}

TEST(Quadratic, finds_both_roots_in_ascending_order) {
    for (const double A : {1.0, -1.0, 4.0, -0.25}) {
        EXPECT_EQ(roots_of(A, 1, 3), (std::pair{1.0, 3.0})) << A;
        EXPECT_EQ(roots_of(A, -3, -1), (std::pair{-3.0, -1.0})) << A;
        EXPECT_EQ(roots_of(A, -2, 5), (std::pair{-2.0, 5.0})) << A;
        EXPECT_EQ(roots_of(A, 0, 4), (std::pair{0.0, 4.0})) << A;
        EXPECT_EQ(roots_of(A, -4, 0), (std::pair{-4.0, 0.0})) << A;
        EXPECT_EQ(roots_of(A, 2, 2), (std::pair{2.0, 2.0})) << A;
        EXPECT_EQ(roots_of(A, -1, 1), (std::pair{-1.0, 1.0})) << A;
        EXPECT_EQ(roots_of(A, 0, 0), (std::pair{0.0, 0.0})) << A;
    }
}

TEST(Quadratic, a_small_root_beside_a_large_one_keeps_its_digits) {
    for (const double sign :
         {1.0, -1.0}) { // t² − 2·10⁸ t + 1: the schoolbook's difference leaves 7.45e-9 for 5e-9
        const auto [first, second] =
            quadratic_roots(1.0, -1e8 * sign, 1.0, std::sqrt(difference_of_products(1e8, 1e8, 1.0, 1.0)));
        EXPECT_NEAR(sign > 0 ? first : second, sign * 5e-9, 5e-24);
        EXPECT_NEAR(sign > 0 ? second : first, sign * 2e8, 1e-7);
    }
}

struct Shifted {
    double root;
    [[nodiscard]] Jet<double> operator()(double t) const { return {t - root, 1}; }
};

TEST(BracketedRoot, is_found_from_either_side_of_a_sign_change) {
    const auto parabola = [](double t) { return Jet<double>{t * t - 2, 2 * t}; };
    const double root = std::sqrt(2.0);
    EXPECT_NEAR(bracketed_root(parabola, 0.0, 2.0, true, epsilon<double>, 1.0), root, 4e-16);
    EXPECT_NEAR(bracketed_root(parabola, -2.0, 0.0, false, epsilon<double>, -1.0), -root, 4e-16);
    EXPECT_EQ(bracketed_root(Shifted{0.5}, 0.0, 1.0, true, epsilon<double>, 0.25), 0.5);
    EXPECT_EQ(bracketed_root(Shifted{0.5}, 0.0, 1.0, true, epsilon<double>, 0.5), 0.5);
}

TEST(BracketedRoot, newton_that_would_leave_the_bracket_is_replaced_by_bisection) {
    // Newton alone diverges on the cube root, and has no slope to divide by on the step.
    const auto cube_root = [](double t) {
        const double slope = 1 / (3 * std::pow(std::cbrt(t - 0.3), 2));
        return Jet<double>{std::cbrt(t - 0.3), slope};
    };
    EXPECT_NEAR(bracketed_root(cube_root, -1.0, 2.0, true, epsilon<double>, 1.9), 0.3, 1e-15);
    const auto step = [](double t) { return Jet<double>{t < 0.7 ? 1.0 : -1.0, 0.0}; };
    EXPECT_NEAR(bracketed_root(step, 0.0, 1.0, false, epsilon<double>, 0.5), 0.7, 1e-15);
}

TEST(BracketedRoot, a_thousand_random_cubics) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double root = random.uniform(-1, 1), a = random.uniform(0.01, 5),
                     scale = random.coin() ? 1 : -1;
        const auto f = [&](double t) { // one real root
            const double u = t - root;
            return Jet<double>{scale * u * (u * u + a), scale * (3 * u * u + a)};
        };
        const double start = random.uniform(-1.9, 1.9);
        const double found = bracketed_root(f, -2.0, 2.0, scale > 0, epsilon<double>, start);
        ASSERT_NEAR(found, root, 4e-16) << hex(root) << ' ' << hex(a) << ' ' << scale << ' ' << hex(start);
    }
}

TEST(Cubic, value_and_slope) {
    const std::array<double, 4> c{2, -3, 5, 7};
    EXPECT_EQ(cubic(c, 2.0).value, 2 - 6 + 20 + 56);
    EXPECT_EQ(cubic(c, 2.0).slope, -3 + 20 + 84);
    EXPECT_EQ(cubic(c, -1.0).value, 2 + 3 + 5 - 7);
}

std::vector<double> sign_changes(const std::array<double, 4>& c, double low, double high) {
    const CubicRoots<double> roots = cubic_sign_changes(c, low, high);
    return {roots.items.begin(), roots.items.begin() + roots.count};
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-8);
}

TEST(Cubic, sign_changes_in_the_bracket_are_found_in_order) {
    const std::array<double, 4> c{6, -5, -2, 1}; // (t + 2)(t − 1)(t − 3)
    const std::array<double, 4> minus{-6, 5, 2, -1};
    for (const auto& f : {c, minus}) {
        expect_near(sign_changes(f, -10, 10), {-2, 1, 3});
        expect_near(sign_changes(f, -10, 2), {-2, 1});
        expect_near(sign_changes(f, 0, 10), {1, 3});
        expect_near(sign_changes(f, 2, 10), {3});
        expect_near(sign_changes(f, 4, 10), {});
        expect_near(sign_changes(f, -10, -3), {});
    }
    expect_near(sign_changes({1, 1, 0, 1}, -5, 5), {-0.6823278038280193}); // t³ + t + 1: no turn
    expect_near(sign_changes({0, 0, 0, 1}, -1, 2), {0});
    expect_near(sign_changes({-1, 2, 0, 0}, -5, 5), {0.5}); // degenerate: a line
}

} // namespace
} // namespace rayscope::test
