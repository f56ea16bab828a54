#include "core/stage/balls.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Solid, t_is_shared_by_both_spaces) {
    const Solid<double> solid = placed(Sphere<double>{}, translation({0, 0, -7}) * scaling(1, 1, 2));
    const auto list = solid.intervals({{0, 0, 1}, {0, 0, -0.5}});
    ASSERT_EQ(list.count, 1);
    EXPECT_EQ(list.items[0].enter, 12); // the surface at z = −5
    EXPECT_EQ(list.items[0].exit, 20);
    EXPECT_EQ(solid.normal({{0, 0, 1}, {0, 0, -0.5}}, 12, 0), (Vec3d{0, 0, 1}));
}

TEST(Solid, a_sphere_that_no_matrix_distorts_becomes_a_ball_with_the_same_crossings) {
    int balls = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(3000)); ++seed) {
        Random random(seed);
        const double scale = random.decade(-3, 3);
        const Mat4d m = translation(random.in_cube(5)) * random_rotation(random) * scaling(scale);
        SceneBuilder b;
        b.generic(Sphere<double>{}, m, b.glowing({1, 1, 1}));
        const Workbench bench = b.open();
        const Solid<double>& ball = bench.world.solids[0];
        if (!ball.is_ball) continue; // the rounded rotation distorts a little
        ++balls;
        ASSERT_TRUE(bench.world.is_ball(bench.world.objects[0]));
        const Solid<double> sphere = placed(Sphere<double>{}, m);
        Ray<double> ray{random.in_cube(8), {}};
        ray.direction = Vec3d{m[3]} + 1.2 * scale * random.in_cube(1) - ray.origin;
        const auto one = ball.intervals(ray), other = sphere.intervals(ray);
        const std::string what = hex(m) + hex(ray) + " seed " + std::to_string(seed);
        if (one.count != other.count) { // a graze
            const auto& found = one.count > 0 ? one : other;
            ASSERT_LT(found.items[0].exit - found.items[0].enter, 1e-5 * scale) << what;
            continue;
        }
        for (int i = 0; i < one.count; ++i)
            for (const auto end : {&Interval<double>::enter, &Interval<double>::exit}) {
                const double t = one.items[std::size_t(i)].*end, u = other.items[std::size_t(i)].*end;
                // The rotation matrix is itself rounded: as much again.
                ASSERT_LE(std::abs(t - u), 2 * (ball.error_bound(ray, t, 0) + sphere.error_bound(ray, u, 0)))
                    << what;
            }
    }
    EXPECT_GT(balls, samples(3000) / 2);
}

TEST(Solid, a_distorted_sphere_or_another_shape_is_no_ball) {
    SceneBuilder b;
    const auto m = b.glowing({1, 1, 1});
    b.generic(Sphere<double>{}, scaling(1, 1, 1.0001), m);
    b.generic(Cube<double>{}, Mat4d{1}, m);
    b.operand("a", Sphere<double>{});
    b.compound("c", "a", m);
    const Workbench bench = b.open();
    for (const Object& object : bench.world.objects) EXPECT_FALSE(bench.world.is_ball(object));
}

TEST(Balls, meet_a_ball_exactly_where_its_kernel_finds_a_chord) {
    SceneBuilder b;
    const auto m = b.glowing({1, 1, 1});
    Random random(5);
    for (int i = 0; i < 150; ++i) { // more than two blocks, with other objects between
        b.generic(Sphere<double>{}, translation(random.in_cube(3)) * scaling(random.uniform(0.01, 0.8)), m);
        if (i % 7 == 0) b.generic(Cube<double>{}, translation(random.in_cube(3)), m);
    }
    const Workbench bench = b.open();
    Balls<double> balls;
    for (std::uint32_t id = 0; id < bench.world.objects.size(); ++id)
        if (bench.world.is_ball(bench.world.objects[id]))
            balls.add(bench.world.solids[bench.world.objects[id].index], id);
    balls.pad();
    ASSERT_EQ(balls.size(), 152U);
    std::size_t met_in_all = 0;
    for (int i = 0; i < samples(3000); ++i) {
        const Ray<double> ray{random.in_cube(4), random.direction() * random.decade(-5, 5)};
        std::vector<std::uint32_t> met, expected;
        const std::size_t end = balls.each_met(ray, 0, balls.size(), [&](std::uint32_t id) {
            met.push_back(id);
            return false;
        });
        for (std::uint32_t id = 0; id < bench.world.objects.size(); ++id)
            if (bench.world.is_ball(bench.world.objects[id]) &&
                bench.world.solids[bench.world.objects[id].index].intervals(ray).count > 0)
                expected.push_back(id);
        ASSERT_EQ(met, expected) << hex(ray);
        ASSERT_EQ(end, 152U);
        met_in_all += met.size();
        if (met.size() < 2) continue;
        std::vector<std::uint32_t> until_second;
        balls.each_met(ray, 0, balls.size(), [&](std::uint32_t id) {
            until_second.push_back(id);
            return until_second.size() == 2;
        });
        ASSERT_EQ(until_second, (std::vector<std::uint32_t>{met[0], met[1]})) << hex(ray);
    }
    EXPECT_GT(met_in_all, std::size_t(samples(3000)));
}

// s t + h t² / 2 = ±δ, solved without approximation.
TEST(RootShift, is_the_farthest_that_the_root_can_move) {
    EXPECT_DOUBLE_EQ(root_shift(0.5, -2.0, 0.0), 0.25);
    EXPECT_DOUBLE_EQ(root_shift(0.5, 0.0, 4.0), 0.5); // a graze: √(2δ / h)
    for (const double slope : {0.5, 2.0, -3.0})
        for (const double curvature : {0.25, 1.0, 4.0}) {
            const double delta = 0.9 * slope * slope / (2 * curvature); // the two roots still exist
            const double shift = root_shift(delta, slope, curvature);
            EXPECT_NEAR(std::abs(slope) * shift - curvature * shift * shift / 2, delta, 1e-14);
            EXPECT_LT(shift, std::abs(slope) / curvature);
        }
    EXPECT_DOUBLE_EQ(root_shift(8.0, 2.0, 1.0), 4.0); // beyond: they merge
}

TEST(Solid, unbounded_ends_have_no_error) {
    EXPECT_EQ(placed(Plane<double>{}, Mat4d{1}).error_bound({{0, 0, 1}, {0, 0, -1}}, infinity<double>, 0), 0);
}

TEST(Camera, the_middle_of_each_pixel_from_the_top_left) {
    Camera camera; // at (0, 0, 5), looks along −z, 45° high
    camera.field_of_view = 90;
    const EyeRays rays(camera, 4, 2);
    const auto expect = [&](double x, double y, const Vec3d& d) {
        const Ray<double> ray = rays.through(x, y);
        EXPECT_EQ(ray.origin, (Vec3d{0, 0, 5}));
        EXPECT_NEAR(length(ray.direction - normalized(d)), 0, 1e-15) << x << ' ' << y;
    };
    expect(2, 1, {0, 0, -1});
    expect(0, 0, {-2, 1, -1}); // the top left corner
    expect(4, 2, {2, -1, -1});
    expect(0.5, 0.5, {-1.5, 0.5, -1});
}

TEST(Counters, add_up) {
    Counters a, b;
    b.rays = {1, 2, 3, 4};
    b.tests[2] = 5;
    b.objects = 6;
    b.compounds = 7;
    b.cut_by_depth = 8;
    b.cut_by_weight = 9;
    b.cut_by_ray_limit = 10;
    b.total_reflections = 11;
    a += b;
    a += b;
    EXPECT_EQ(a.rays, (std::array<std::uint64_t, 4>{2, 4, 6, 8}));
    EXPECT_EQ(a.tests[2], 10U);
    EXPECT_EQ(a.objects + a.compounds + a.cut_by_depth + a.cut_by_weight + a.cut_by_ray_limit +
                  a.total_reflections,
              2U * (6 + 7 + 8 + 9 + 10 + 11));
}

} // namespace
} // namespace rayscope::test
