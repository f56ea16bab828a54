// Guards against an octree that grows without bound, or that loses a hit where its limits are unusual.

#include "core/extents/scan.hpp"
#include "core/octree/octree.hpp"
#include "core/scene/build.hpp"
#include "tests/agreement/random_scene.hpp"
#include "tests/agreement/same_answers.hpp"

#include <cmath>

namespace rayscope::test {
namespace {

struct Ball {
    Vec3d centre;
    double radius;
};

World<double> world_of(const std::vector<Ball>& balls) {
    SceneBuilder b;
    const std::size_t material = b.clear(0, 0, 1);
    for (const Ball& ball : balls)
        b.generic(Sphere<double>{}, translation(ball.centre) * scaling(ball.radius), material);
    return build(b.scene());
}

std::vector<Ball> cloud(std::size_t count, double radius, const Vec3d& size, Random& random) {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < count; ++i) balls.push_back({size * random.in_cube(1), radius});
    return balls;
}

void expect_scans_answers(const World<double>& world, const Octree<double>& tree, double reach,
                          Random& random) {
    const Scan<double> scan(world);
    for (int i = 0; i < 2000; ++i) {
        Ray<double> ray{random.in_cube(3 * reach), {}};
        ray.direction = normalized(random.in_cube(reach) - ray.origin);
        const Answers expected = answers(world, scan, ray, infinity<double>),
                      found = answers(world, tree, ray, infinity<double>);
        ASSERT_TRUE(found == expected)
            << hex(ray) << "\n  scan: " << described(expected) << "\n  octree: " << described(found);
    }
}

// Each object in at most so many leaves on average, whatever the scene.
void expect_bounded(const Octree<double>& tree, std::size_t objects) {
    const OctreeStatistics& s = tree.statistics();
    EXPECT_LE(s.entries, 4096 + 16 * objects);
    EXPECT_LE(s.nodes, 1024 + 8 * objects);
    EXPECT_LE(s.bytes, std::size_t(1) << 21U | 2048 * objects);
}

void expect_bounded_and_right(const std::vector<Ball>& balls, double reach) {
    Random random(7);
    const auto world = world_of(balls);
    const Octree<double> tree(world);
    expect_bounded(tree, balls.size());
    expect_scans_answers(world, tree, reach, random);
}

TEST(OctreeOfDegenerateScenes, all_in_one_point) {
    expect_bounded_and_right(std::vector<Ball>(3000, Ball{{0.3, -0.2, 0.1}, 0.5}), 1);
}
TEST(OctreeOfDegenerateScenes, shells_around_one_point) {
    std::vector<Ball> balls;
    for (int i = 1; i <= 2000; ++i) balls.push_back({{0, 0, 0}, i / 2000.0});
    expect_bounded_and_right(balls, 1);
}
TEST(OctreeOfDegenerateScenes, one_giant_among_thousands_of_tiny_ones) {
    Random random(1);
    auto balls = cloud(5000, 1e-6, Vec3d{1e-3}, random);
    balls.push_back({{2e3, 0, 0}, 2e3 - 0.01});
    expect_bounded_and_right(balls, 2e-3);
}
TEST(OctreeOfDegenerateScenes, flat) {
    Random random(2);
    const auto balls = cloud(5000, 0.01, {1, 0, 1}, random);
    expect_bounded_and_right(balls, 1);
    // No level doubles what lies in the plane.
    EXPECT_LE(Octree<double>(world_of(balls)).statistics().entries, 4 * balls.size());
}
TEST(OctreeOfDegenerateScenes, a_single_one) { expect_bounded_and_right({{{1, 2, 3}, 0.5}}, 4); }
TEST(OctreeOfDegenerateScenes, points) {
    Random random(3);
    expect_bounded_and_right(cloud(1000, 1e-300, Vec3d{1}, random), 1);
}

TEST(OctreeLimits, the_notes_rule_is_a_setting) {
    Random random(4);
    const auto world = world_of(cloud(500, 0.05, Vec3d{1}, random));
    const Octree<double> tree(world, {.capacity = 1, .least_size = 1.0 / 16});
    EXPECT_EQ(tree.statistics().depth, 4);
    EXPECT_EQ(tree.statistics().reasons.capacity, "as asked for");
    expect_scans_answers(world, tree, 1, random);
}
TEST(OctreeLimits, a_depth_that_is_asked_for_is_kept) {
    Random random(5);
    const auto world = world_of(cloud(500, 0.05, Vec3d{1}, random));
    for (const int depth : {1, 2, 3}) {
        const Octree<double> tree(world, {.depth = depth, .capacity = 1});
        EXPECT_EQ(tree.statistics().depth, depth);
        expect_scans_answers(world, tree, 1, random);
    }
}
TEST(OctreeLimits, each_has_a_reason) {
    Random random(6);
    const auto world = world_of(cloud(100, 0.05, Vec3d{1}, random));
    const Octree<double> tree(world);
    EXPECT_FALSE(tree.statistics().reasons.depth.empty());
    EXPECT_FALSE(tree.statistics().reasons.capacity.empty());
    EXPECT_FALSE(tree.statistics().reasons.least_size.empty());
    EXPECT_GT(tree.statistics().limits.least_size, 0);
}
TEST(OctreeLimits, random_scenes_of_all_generics) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        const auto world = build(random_scene(random, 60));
        expect_scans_answers(world, Octree<double>(world, {.capacity = 1, .least_size = 1.0 / 64}), 3,
                             random);
        expect_scans_answers(world, Octree<double>(world, {.depth = 2, .capacity = 3}), 3, random);
    }
}

} // namespace
} // namespace rayscope::test
