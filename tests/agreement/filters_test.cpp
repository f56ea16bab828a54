// Guards against a filter that drops what a kernel would have found: rays that graze, start on the surface, or come from
// far away.

#include "core/boxes/box_tree.hpp"
#include "core/scene/build.hpp"
#include "core/stage/ball_filter.hpp"
#include "core/stage/ball_groups.hpp"
#include "core/stage/unboxed.hpp"
#include "core/world/first_of_object.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

/// A small step to either side, of any size down to the last digit; or none.
double nudge(Random& random) {
    return random.coin() ? 0.0 : (random.coin() ? 1 : -1) * random.decade(-17, -1);
}

bool kernel_finds(const World<double>& world, const Ray<double>& ray, double reach,
                  std::uint32_t object = 0) {
    Work<double> work;
    const LeavingSurface<double>* const nothing = nullptr;
    return first_of_object(world, object, ray, Range<double>{0, reach}, nothing, work).has_value();
}

/// From about a ball's surface, or from farther away, past its rim.
Ray<double> ray_at(Random& random, const Vec3d& centre, double radius) {
    const Vec3d out = random.direction(), aside = normalized(cross(out, random.direction()));
    const double away = random.coin() ? 1 + nudge(random) : random.decade(0, 5);
    const Vec3d origin = centre + radius * away * out;
    const Vec3d target = centre + radius * (1 + nudge(random)) * aside;
    return {origin, random.decade(-2, 2) * (random.coin() ? target - origin : random.direction())};
}

TEST(BallFilter, misses_nothing_that_the_kernel_finds) {
    Random random(3);
    int missed = 0, found = 0;
    for (int i = 0; i < 400; ++i) {
        SceneBuilder b;
        const double radius = random.decade(-3, 3);
        const Vec3d centre = random.in_cube(random.decade(-3, 6));
        b.generic(Sphere<double>{}, translation(centre) * scaling(radius), b.clear(0, 0, 1));
        const auto world = build(b.scene());
        const BallFilter<double> filter(world);
        for (int k = 0; k < 200; ++k) {
            const Ray<double> ray = ray_at(random, centre, radius);
            Counters counters;
            const bool dropped = filter.misses(0, ray, counters),
                       hit = kernel_finds(world, ray, infinity<double>);
            ASSERT_FALSE(dropped && hit) << hex(ray) << " radius " << hex(radius);
            ASSERT_EQ(counters.objects, dropped ? 1U : 0U);
            missed += dropped ? 1 : 0;
            found += hit ? 1 : 0;
        }
    }
    EXPECT_GT(missed, 10'000);
    EXPECT_GT(found, 10'000);
}

TEST(BallGroups, leave_out_nothing_that_the_kernel_finds) {
    Random random(5);
    int left_out = 0, found = 0;
    for (int i = 0; i < 400; ++i) {
        SceneBuilder b;
        const int count = 1 + random.below(2 * int(group_lanes));
        std::vector<std::pair<Vec3d, double>> balls;
        double size = 0;
        const double spread = random.decade(-3, 6);
        for (int k = 0; k < count; ++k) {
            const auto& [centre, radius] =
                balls.emplace_back(random.in_cube(spread), spread * random.decade(-6, 0));
            size = maximum(size, largest_component(absolute(centre)) + radius);
            b.generic(Sphere<double>{}, translation(centre) * scaling(radius), b.clear(0, 0, 1));
        }
        const auto world = build(b.scene());
        const double scale = tree_scale(size);
        BallGroups groups;
        for (std::uint32_t k = 0; k < world.solids.size(); ++k) groups.add(world.solids[k], k, scale);
        groups.end_group();
        groups.close();
        for (int k = 0; k < 100; ++k) {
            const auto& [centre, radius] = balls[std::size_t(random.below(count))];
            const Ray<double> ray = ray_at(random, centre, radius);
            const double reach = random.coin() ? infinity<double> : random.decade(-3, 3);
            const GroupRay group_ray(ray, scale);
            ASSERT_TRUE(group_ray.reliable());
            std::vector<bool> near(std::size_t(count), false);
            groups.each_near(group_ray, reach, 0, groups.size(), [&](std::uint32_t ball) {
                near[ball] = true;
                return false;
            });
            for (std::uint32_t ball = 0; ball < near.size(); ++ball) {
                const bool hit = kernel_finds(world, ray, reach, ball);
                ASSERT_TRUE(near[ball] || !hit)
                    << hex(ray) << " reach " << hex(reach) << " centre " << hex(balls[ball].first)
                    << " radius " << hex(balls[ball].second);
                left_out += near[ball] ? 0 : 1;
                found += hit ? 1 : 0;
            }
        }
    }
    EXPECT_GT(left_out, 10'000);
    EXPECT_GT(found, 10'000);
}

TEST(GroupRay, is_not_reliable_where_floats_are_not) {
    const auto reliable = [](const Vec3d& origin, const Vec3d& direction, double scale) {
        return GroupRay({origin, direction}, scale).reliable();
    };
    EXPECT_TRUE(reliable({1, 2, 3}, {0, 0, 1}, 1));
    EXPECT_TRUE(reliable({1e50, 2e50, 3e50}, {0, 0, 1e-3}, 1e-50));
    EXPECT_FALSE(reliable({1e7, 0, 0}, {0, 0, 1}, 1)) << "far away";
    EXPECT_TRUE(reliable({1, 2, 3}, {0, 0, 1e-17}, 1));
    EXPECT_FALSE(reliable({1, 2, 3}, {0, 0, 1e-19}, 1)) << "short";
    EXPECT_FALSE(reliable({1, 2, 3}, {0, 1e19, 0}, 1)) << "long";
    EXPECT_FALSE(reliable({1, 2, 3}, {0, 1e-300, 0}, 1)) << "its square is 0";
}

/// Asks Unboxed as a stage's search does.
struct Question {
    Ray<double> asked;
    double limit;
    bool tested = false;

    [[nodiscard]] const Ray<double>& ray() const { return asked; }
    [[nodiscard]] double reach() const { return limit; }
    bool test(std::uint32_t /*object*/) { return tested = true; }
};

TEST(Unboxed, misses_nothing_that_the_kernel_finds) {
    Random random(4);
    int spared = 0, found = 0;
    for (int i = 0; i < 800; ++i) {
        SceneBuilder b;
        const Generic<double> shape =
            random.coin() ? Generic<double>(Plane<double>{}) : Generic<double>(triangle());
        Mat4d matrix = translation(random.in_cube(random.decade(-3, 6))) * random_rotation(random);
        if (random.coin()) matrix = matrix * scaling(random.decade(-2, 2), random.decade(-2, 2), 1);
        b.generic(shape, matrix, b.clear(0, 0, 1));
        const auto world = build(b.scene());
        const Unboxed<double> unboxed(world, {0});
        for (int k = 0; k < 200; ++k) {
            // In the plane but for a little, at both ends.
            const auto near_plane = [&] {
                const double height = random.below(3) == 0 ? nudge(random) : random.uniform(-1, 1);
                return Vec3d(matrix * glm::dvec4(random.uniform(-1, 1), random.uniform(-1, 1), height, 1));
            };
            const Vec3d origin = near_plane();
            Question question{{origin, near_plane() - origin},
                              random.coin() ? infinity<double> : random.decade(-1, 1)};
            (void)unboxed.test(question);
            const bool hit = kernel_finds(world, question.asked, question.limit);
            ASSERT_FALSE(hit && !question.tested) << hex(question.asked) << " reach " << hex(question.limit);
            spared += question.tested ? 0 : 1;
            found += hit ? 1 : 0;
        }
    }
    EXPECT_GT(spared, 10'000);
    EXPECT_GT(found, 10'000);
}

TEST(Unboxed, tests_what_is_no_plane) {
    SceneBuilder b;
    b.generic(OpenCone<double>{}, Mat4d{1}, b.clear(0, 0, 1));
    const Unboxed<double> unboxed(build(b.scene()), {0});
    Question away{{{0, 0, 99}, {0, 0, 1}}, 1};
    EXPECT_TRUE(unboxed.test(away));
}

} // namespace
} // namespace rayscope::test
