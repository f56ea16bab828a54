// chapters/errata.md, what concerns refraction: the printed form fails, the right one holds.

#include "core/refraction/snell.hpp"
#include "tests/errata/scenes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rayscope::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(Refraction, index) {
    const double air = 1, glass = 1 / 1.5;
    EXPECT_LT(glass / air, 0.67) << "as printed, glass would have an index below that of air";
    EXPECT_NEAR(air / glass, 1.5, 1e-15);
    // Snell's law itself takes c₂ / c₁, and is right.
    const auto bent = refract<double>(Vec3d{0.5, 0, -std::sqrt(0.75)}, Vec3d{0, 0, 1}, air, glass);
    EXPECT_NEAR(std::sin(bent.theta_to()), glass / air * 0.5, 1e-15);
}

Vec3d printed_direction(const Vec3d& d, const Vec3d& n, double eta) {
    const double along = dot(n, d), radicand = 1 - eta * eta * (1 - along * along);
    return eta * d + (eta * along - std::sqrt(radicand)) * n;
}
Vec3d right_direction(const Vec3d& d, const Vec3d& n, double eta) {
    const double along = dot(n, d), radicand = 1 - eta * eta * (1 - along * along);
    return eta * d - (eta * along + std::sqrt(radicand)) * n;
}

TEST(Refraction, refracted_direction) {
    const Vec3d d{0.5, 0, -std::sqrt(0.75)}, n{0, 0, 1}; // 30°, the normal against the ray
    const double eta = 1 / 1.5;
    EXPECT_NEAR(length(printed_direction(d, n, eta)), 2.1238, 1e-4);
    EXPECT_NEAR(length(printed_direction(d, -n, eta)), 0.39498, 1e-5) << "nor with the other normal";
    EXPECT_NEAR(length(printed_direction(d, n, 1) - d), std::sqrt(3.0), 1e-15) << "nothing to bend, and bent";

    const Vec3d t = right_direction(d, n, eta);
    EXPECT_NEAR(length(t), 1, 1e-15);
    EXPECT_LT(length(right_direction(d, n, 1) - d), 1e-15);
    EXPECT_NEAR(std::asin(t.x), 19.4712206 * degree, 1e-9);
    EXPECT_LT(length(refract<double>(d, n, 1.0, eta).direction - t), 1e-15);
}

TEST(Refraction, critical_angle) {
    EXPECT_NEAR(critical_angle(1 / 1.33, 1).value() / degree, 48.7535, 1e-4);
    EXPECT_FALSE(critical_angle(1, 1 / 1.33)) << "none into the slower medium";
    EXPECT_FALSE(critical_angle(1, 1));

    // What entered a ball from outside meets its far wall at the angle θ₂ of its entry.
    const Workbench ball = chapter_scene("04_refraction/glass_ball.toml"),
                    bubble = chapter_scene("04_refraction/bubble.toml");
    int total = 0;
    for (int i = 0; i < 1000; ++i) {
        const Ray<double> ray{{0.001 * i, 0, 5}, {0, 0, -1}};
        const Trace inside = trace_ray(ball, ray);
        for (const TracedRay& each : inside.rays)
            ASSERT_EQ(each.find<TotallyReflected>(), nullptr) << "x = " << 0.001 * i;
        if (trace_ray(bubble, ray).rays.front().find<TotallyReflected>() != nullptr) ++total;
    }
    EXPECT_NEAR(total, 1000 * (1 - 1 / 1.333), 1.5) << "a bubble shows it from x = 1 / 1.333 on";
}

TEST(Refraction, air_outside) {
    const Ray<double> in_glass{{0, -0.5, 0}, {1, 1, 0}}; // 45° onto a wall under water
    Workbench bench = chapter_scene("04_refraction/glass_in_water.toml");
    const TracedRay right = trace_ray(bench, in_glass).rays.front();
    ASSERT_NE(right.find<Refracted>(), nullptr);
    EXPECT_NEAR(right.find<Refracted>()->theta_to / degree, 52.891, 1e-3);
    bench.world.notes_media = true;
    EXPECT_NE(trace_ray(bench, in_glass).rays.front().find<TotallyReflected>(), nullptr) << "as printed";
}

} // namespace
} // namespace rayscope::test
