#include "core/refraction/snell.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rayscope::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec3d at_angle(double theta) { return {std::sin(theta), 0, -std::cos(theta)}; } // down onto the plane z = 0

TEST(Snell, sines_keep_the_ratio_of_the_speeds) {
    int refracted = 0, total = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
        Random random(seed);
        const Vec3d d = random.direction(), n = random.direction() * random.decade(-3, 3);
        const double from = random.uniform(0.3, 1.5), to = random.uniform(0.3, 1.5);
        const Refraction<double> r = refract<double>(d, n, from, to);
        const std::string what =
            hex(d) + hex(n) + hex(from) + ' ' + hex(to) + " seed " + std::to_string(seed);
        const Vec3d unit = normalized(n);
        const double sine = length(cross(d, unit));
        const Vec3d facing = dot(unit, d) > 0 ? -unit : unit;
        ASSERT_NEAR(r.cosine, std::abs(dot(d, unit)), 1e-15) << what;
        ASSERT_NEAR(r.sine, sine, 1e-15) << what;
        ASSERT_EQ(r.eta, to / from) << what;
        ASSERT_NEAR(r.radicand, 1 - r.eta * r.eta * sine * sine, 1e-14 * (1 + r.eta * r.eta)) << what;
        if (std::abs(r.radicand) < 1e-6) continue;
        ASSERT_EQ(r.total(), r.eta * sine > 1) << what;
        if (r.total()) {
            ++total;
            continue;
        }
        ++refracted;
        ASSERT_NEAR(length(r.direction), 1, 1e-14) << what;
        ASSERT_LT(dot(r.direction, facing), 0) << "it goes on to the other side: " << what;
        ASSERT_NEAR(length(cross(r.direction, facing)), r.eta * sine, 1e-14) << what;
        ASSERT_NEAR(dot(cross(d, r.direction), unit), 0, 1e-15) << "out of the plane of incidence: " << what;
        ASSERT_GE(dot(cross(r.direction, facing), cross(d, facing)), 0) << "bent across the normal: " << what;
        ASSERT_NEAR(r.theta_from(), std::asin(std::min(1.0, sine)), 1e-7) << what;
        ASSERT_NEAR(std::sin(r.theta_to()), r.eta * sine, 1e-14) << what;
    }
    EXPECT_GT(refracted, samples(10000));
    EXPECT_GT(total, samples(1000));
}

TEST(Snell, air_to_glass_at_sixty_degrees) {
    const Refraction<double> r = refract<double>(at_angle(60 * degree), {0, 0, 1}, 1.0, 1 / 1.5);
    EXPECT_NEAR(r.theta_from(), 60 * degree, 1e-15);
    EXPECT_NEAR(r.theta_to(), 35.264389682754654 * degree, 1e-15); // sin 60° / 1.5 = 1/√3
    EXPECT_NEAR(r.direction.x, 1 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(r.direction.z, -std::sqrt(2.0 / 3), 1e-15);
}

TEST(Snell, equal_speeds_leave_the_direction_bit_for_bit) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        Random random(seed);
        const Vec3d d = normalized(random.direction());
        const double speed = random.uniform(0.2, 2);
        const Refraction<double> r = refract<double>(d, random.direction(), speed, speed);
        ASSERT_EQ(r.direction, normalized(d)) << hex(d) << " seed " << seed;
        ASSERT_FALSE(r.total());
    }
}

TEST(Snell, straight_onto_the_surface_nothing_bends) {
    for (const double side : {1.0, -1.0}) {
        const Refraction<double> r = refract<double>({0, 0, -1}, {0, 0, side}, 1.0, 0.5);
        EXPECT_EQ(r.direction, (Vec3d{0, 0, -1}));
        EXPECT_EQ(r.theta_from(), 0);
        EXPECT_EQ(r.theta_to(), 0);
    }
}

TEST(Snell, the_normal_may_lie_on_either_side) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Vec3d d = random.direction(), n = random.direction();
        ASSERT_EQ(refract<double>(d, n, 1.0, 0.7).direction, refract<double>(d, -n, 1.0, 0.7).direction)
            << hex(d) << hex(n);
    }
}

TEST(Snell, critical_angle_from_water_to_air) {
    ASSERT_TRUE(critical_angle(0.7519, 1.0).has_value());
    EXPECT_NEAR(*critical_angle(0.7519, 1.0) / degree, 48.755, 0.0005);
    EXPECT_FALSE(critical_angle(1.0, 0.7519).has_value());
    EXPECT_FALSE(critical_angle(1.0, 1.0).has_value());
    const double critical = *critical_angle(0.7519, 1.0);
    EXPECT_FALSE(refract<double>(at_angle(critical - 1e-9), {0, 0, 1}, 0.7519, 1.0).total());
    EXPECT_TRUE(refract<double>(at_angle(critical + 1e-9), {0, 0, 1}, 0.7519, 1.0).total());
    // On the edge itself, where the radicand is 0, the ray runs along the surface.
    const Refraction<double> edge = refract<double>({0.6, 0, -0.8}, {0, 0, 1}, 0.6, 1.0);
    EXPECT_NEAR(edge.radicand, 0, 1e-15);
    EXPECT_FALSE((Refraction<double>{1, 0, 1, 0.0, {}}.total()));
}

// cos² θ₂ against 113 bits: where a ray grazes and the media differ by little, 1 − η²(1 − cos²) would keep 4 digits.
TEST(Snell, grazing_rays_and_nearly_equal_media_keep_their_digits) {
    for (const double slope : {0x1p-20, 0x1p-26, 0x1p-30})
        for (const double difference : {0x1p-44, -0x1p-44, 0x1p-30, -0x1p-52}) {
            const Vec3d d = normalized(Vec3d{0.6, 0.8, -slope});
            const double to = 1 - difference;
            const Wide x = Wide(d.x), y = Wide(d.y), z = Wide(d.z), eta = Wide(to);
            const Wide cosine_squared = z * z / (x * x + y * y + z * z);
            const double exact = double(1 - eta * eta * (1 - cosine_squared));
            const Refraction<double> r = refract<double>(d, {0, 0, 1}, 1.0, to);
            EXPECT_NEAR(r.radicand / exact, 1, 1e-13) << slope << ' ' << difference;
            EXPECT_NEAR(r.cosine / slope, 1, 1e-11);
        }
}

// Near the normal the sine, which is small, keeps its digits and so do both angles.
TEST(Snell, small_angles_keep_their_digits) {
    for (const double theta : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const Refraction<double> r = refract<double>({theta, 0, -1}, {0, 0, 1}, 1.0, 0.5);
        EXPECT_NEAR(r.theta_from() / std::atan(theta), 1, 1e-15);
        EXPECT_NEAR(r.theta_to() / std::asin(0.5 * std::sin(std::atan(theta))), 1, 2e-15);
    }
}

} // namespace
} // namespace rayscope::test
