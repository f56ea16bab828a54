// Digits that the schoolbook's formulas would lose.

#include "tests/support/exact.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// The exact crossing lies within `tolerance` · |t| of t.
void expect_relative(const Generic<double>& shape, const Ray<double>& ray, double t, double tolerance) {
    const WideRay exact = exact_object_ray(Mat4d{1}, ray);
    const Wide step = Wide(t) * Wide(tolerance);
    const bool before = face_value(shape, 0, exact.at(Wide(t) - step)) < 0;
    const bool after = face_value(shape, 0, exact.at(Wide(t) + step)) < 0;
    EXPECT_NE(before, after) << generic_name(shape) << ' ' << hex(ray) << " t " << hex(t);
}

// From 6·10⁻¹¹ beside the wall the near root is that small; it comes from the product of the roots with all its digits.
TEST(Precision, a_root_close_to_the_start_keeps_its_digits) {
    for (const Generic<double>& shape :
         {Generic<double>(Sphere<double>{}), Generic<double>(Cylinder<double>{})})
        for (const double beside : {0x1p-34, -0x1p-34})
            for (const double way : {1.0, -1.0}) {
                const Ray<double> ray{{0, 1 + beside, 0}, {0.7 * way, 0.6 * way, 0.1 * way}};
                const Intervals<double> list = intervals(shape, ray);
                ASSERT_EQ(list.count, 1) << hex(ray);
                const Interval<double>& span = list.items[0];
                const bool enters_near = std::abs(span.enter) < std::abs(span.exit);
                expect_relative(shape, ray, enters_near ? span.enter : span.exit, 1e-14);
                expect_relative(shape, ray, enters_near ? span.exit : span.enter, 1e-14);
                EXPECT_LT(std::abs(enters_near ? span.enter : span.exit), 2e-10);
            }
}

// From this distance the first guess of the closest point is off by a good part of the sphere; its residual repairs
// that. Asked where t can tell the ends of the chord apart.
TEST(Precision, hit_or_miss_is_decided_by_the_distance_from_the_centre_even_from_afar) {
    int near_the_limb = 0;
    for (std::uint64_t seed = 1; seed <= 100000; ++seed) {
        Random random(seed);
        Vec3d direction = random.direction();
        Vec3d sideways = normalized(cross(direction, random.direction()));
        Vec3d origin = 0x1p45 * direction + random.uniform(0.99, 1.01) * sideways;
        for (const Generic<double>& shape :
             {Generic<double>(Sphere<double>{}), Generic<double>(Cylinder<double>{})}) {
            if (std::holds_alternative<Cylinder<double>>(shape)) {
                direction = normalized(Vec3d{direction.x, direction.y, 0});
                sideways = {-direction.y, direction.x, 0};
                origin = 0x1p45 * direction + random.uniform(0.99, 1.01) * sideways;
            }
            const WideRay ray = exact_object_ray(Mat4d{1}, {origin, direction});
            const auto product = [](const WideVec& a, const WideVec& b) {
                return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            };
            const Wide dd = product(ray.direction, ray.direction), od = product(ray.origin, ray.direction);
            const WideVec q = ray.at(-od / dd);
            const double squared = double((1 - product(q, q)) / dd), step = 0x1p-7;
            const std::string what = hex(Ray<double>{origin, direction}) + " seed " + std::to_string(seed);
            if (squared > 4 * step * step) {
                const Intervals<double> list = intervals(shape, {origin, direction});
                ASSERT_EQ(list.count, 1) << what;
                const Wide middle = (Wide(list.items[0].enter) + Wide(list.items[0].exit)) / 2;
                ASSERT_NEAR(double(middle + od / dd), 0, 1.5 * step) << what;
            }
            if (squared < -1e-6) {
                ASSERT_EQ(intervals(shape, {origin, direction}).count, 0) << what;
            }
            near_the_limb += std::abs(squared) < 0.001 ? 1 : 0;
        }
    }
    EXPECT_GT(near_the_limb, 1000);
}

TEST(Precision, a_ray_close_to_a_generator_of_the_cone) {
    const Cone<double> cone;
    for (const double tilt : {0x1p-20, -0x1p-20, 0x1p-40, -0x1p-40})
        for (const double inward : {0x1p-10, 0x1p-25}) {
            const Ray<double> ray{{0.5 - inward, 0, 0}, {-0.5 + tilt, 0, 1}};
            const Intervals<double> list = intervals(cone, ray);
            ASSERT_EQ(list.count, 1) << hex(ray);
            // Tilted outwards by more than it starts within, it comes in by the wall and not by the base.
            const bool by_wall = -tilt > inward;
            EXPECT_EQ(list.items[0].enter_face, by_wall ? 0 : 1);
            EXPECT_NEAR(list.items[0].enter, by_wall ? inward / tilt : -1, 1e-10);
            // x = 0 lies beyond w = 0: the ray leaves by the wall on the other side of the apex.
            EXPECT_EQ(list.items[0].exit_face, 0);
            expect_relative(cone, ray, list.items[0].exit, 1e-13);
        }
}

TEST(Precision, a_double_root_of_the_torus_is_two_crossings_or_none) {
    for (const double minor : {0.25, 0.5}) {
        const Torus<double> torus{minor};
        // Tangent to the inner circle from within the ring: one interval, or two that meet in the middle.
        const Intervals<double> inner = torus.intervals({{-3, 1 - minor, 0}, {1, 0, 0}});
        ASSERT_GE(inner.count, 1);
        const double half = std::sqrt((1 + minor) * (1 + minor) - (1 - minor) * (1 - minor));
        EXPECT_NEAR(inner.items[0].enter, 3 - half, 1e-14);
        EXPECT_NEAR(inner.items[std::size_t(inner.count) - 1].exit, 3 + half, 1e-14);
        if (inner.count == 2) {
            EXPECT_NEAR(inner.items[0].exit, inner.items[1].enter, 1e-7);
        }
        // The plane on top touches the whole circle: four equal roots in pairs.
        for (const Interval<double>& span : torus.intervals({{-3, 0, minor}, {1, 0, 0}}))
            EXPECT_LT(span.exit - span.enter, 1e-7);
        // Just below and just above it.
        const double below = minor - 1e-10;
        const double width = std::sqrt(minor * minor - below * below);
        const Intervals<double> four = torus.intervals({{-3, 0, below}, {1, 0, 0}});
        ASSERT_EQ(four.count, 2);
        EXPECT_NEAR(four.items[0].enter, 2 - width, 1e-10);
        EXPECT_NEAR(four.items[0].exit, 2 + width, 1e-10);
        EXPECT_NEAR(four.items[1].enter, 4 - width, 1e-10);
        EXPECT_NEAR(four.items[1].exit, 4 + width, 1e-10);
        EXPECT_EQ(torus.intervals({{-3, 0, minor + 1e-10}, {1, 0, 0}}).count, 0);
        // The sphere around the torus touches it along the outer circle.
        EXPECT_EQ(torus.intervals({{-3, 1 + minor + 1e-10, 0}, {1, 0, 0}}).count, 0);
        EXPECT_EQ(torus.intervals({{-3, 1 + minor - 1e-10, 0}, {1, 0, 0}}).count, 1);
    }
}

TEST(Precision, a_far_torus_still_has_four_crossings) {
    for (const double far : {1e3, 1e6, 1e9}) {
        const Intervals<double> list = Torus<double>{0.25}.intervals({{-far, 0, 0}, {1, 0, 0}});
        ASSERT_EQ(list.count, 2) << far;
        EXPECT_NEAR(list.items[0].enter, far - 1.25, far * epsilon<double>);
        EXPECT_NEAR(list.items[1].exit, far + 1.25, far * epsilon<double>);
    }
}

} // namespace
} // namespace rayscope::test
