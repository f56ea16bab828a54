// The test of sixteen triangles at once leaves out none that a kernel would find: a hole in a mesh that depends on which
// triangles share a leaf.

#include "core/boxes/box_tree.hpp"
#include "core/generics/polygon.hpp"
#include "core/generics/triangle_ray.hpp"
#include "core/mesh/triangle_groups.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rayscope::test {
namespace {

using Corners = std::array<Vec3d, 3>;

// Slivers, points, and triangles of all sizes, near and far.
Corners some_triangle(Random& random) {
    const Vec3d place = random.in_cube(random.decade(-2, 6));
    const double size = random.decade(-6, 3), thinness = random.coin() ? 1 : random.decade(-16, 0);
    const Vec3d along = random.direction() * size, across = random.direction() * (size * thinness);
    return {place, place + along, place + along * random.uniform(0, 1) + across};
}

// Towards a corner, a point of an edge, a point within or beside, or in the plane.
Ray<double> some_ray(Random& random, const Corners& t) {
    const std::array<std::array<double, 3>, 4> shares{
        {{1, 0, 0}, {0.5, 0.5, 0}, {0.2, 0.3, 0.5}, {1.4, -0.2, -0.2}}};
    const auto& share = shares[std::size_t(random.below(4))];
    const Vec3d target = share[0] * t[0] + share[1] * t[1] + share[2] * t[2];
    const Vec3d away = random.below(4) == 0 ? (t[1] - t[0]) + (t[2] - t[0]) * random.uniform(-1, 1)
                                            : random.direction() * random.decade(-6, 6);
    const Vec3d origin = target + away;
    return {origin, (target - origin) * random.decade(-3, 3)};
}

template <Numbers N> void expect_all_found(std::uint64_t seed) {
    using T = ScalarOf<N>;
    Random random(seed);
    const int rounds = int(2000 * effort());
    int found = 0;
    for (int round = 0; round < rounds; ++round) {
        TriangleGroups groups;
        std::vector<Corners> triangles;
        const int count = 1 + random.below(int(group_lanes));
        double size = 0;
        for (int i = 0; i < count; ++i) {
            triangles.push_back(some_triangle(random));
            for (const Vec3d& corner : triangles.back())
                size = maximum(size, largest_component(absolute(corner)));
        }
        const double scale = tree_scale(size);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            groups.add(triangles[i][0], triangles[i][1], triangles[i][2], std::uint32_t(i), scale);
        groups.end_group();
        groups.close();
        for (const Corners& aim : triangles) {
            const Ray<double> ray = as<double>(as<T>(some_ray(random, aim)));
            const double reach = random.coin() ? infinity<double> : random.decade(-3, 6);
            std::set<std::uint32_t> near;
            const double unit = maximum(double(epsilon<T>), epsilon<double>);
            const GroupRay group_ray(ray, scale);
            if (!group_ray.reliable()) continue;
            groups.each_near(
                group_ray, reach, 0, std::size_t(count),
                [&](std::uint32_t i) { return !near.insert(i).second; }, unit);
            const TriangleRay<N> kernel(as<T>(ray));
            for (std::uint32_t i = 0; i < triangles.size(); ++i) {
                const auto corner = [&](std::size_t k) { return as<T>(triangles[i][k]); };
                const auto hit = kernel.hit(corner(0), corner(1), corner(2));
                if (!hit || hit->t < T(0) || double(hit->t) > reach) continue;
                ++found;
                EXPECT_TRUE(near.contains(i))
                    << "seed " << seed << ", round " << round << ", t = " << double(hit->t) << ", ray "
                    << hex(ray.origin) << " → " << hex(ray.direction) << ", triangle " << hex(triangles[i][0])
                    << hex(triangles[i][1]) << hex(triangles[i][2]);
            }
        }
    }
    EXPECT_GT(found, rounds / 2);
}

TEST(TriangleGroups, leave_out_nothing_that_a_kernel_finds) {
    expect_all_found<double>(1);
    expect_all_found<float>(2);
    expect_all_found<long double>(3);
}

TEST(TriangleGroups, leave_out_nothing_that_the_schoolbook_finds) { expect_all_found<Textbook<double>>(4); }

TEST(TriangleGroups, leave_out_what_is_beside_behind_or_beyond) {
    TriangleGroups groups;
    groups.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 7, 1);
    groups.end_group();
    groups.close();
    const auto near = [&](const Vec3d& origin, const Vec3d& direction, double reach) {
        bool met = false;
        groups.each_near(GroupRay({origin, direction}, 1), reach, 0, 1,
                         [&](std::uint32_t object) { return met = object == 7; });
        return met;
    };
    EXPECT_TRUE(near({0.2, 0.2, 1}, {0, 0, -1}, infinity<double>));
    EXPECT_TRUE(near({0.2, 0.2, 1}, {0, 0, -1}, 1));
    EXPECT_FALSE(near({0.2, 0.2, 1}, {0, 0, -1}, 0.9)) << "beyond";
    EXPECT_FALSE(near({0.2, 0.2, 1}, {0, 0, 1}, infinity<double>)) << "behind";
    EXPECT_FALSE(near({0.6, 0.6, 1}, {0, 0, -1}, infinity<double>)) << "beside";
    EXPECT_FALSE(near({-0.1, 0.2, 1}, {0, 0, -1}, infinity<double>)) << "beside";
    EXPECT_FALSE(near({0.2, -0.1, 1}, {0, 0, -1}, infinity<double>)) << "beside";
}

// Floats end at 10^38 and begin at 10^−45, in units of the tree: that far, all are kept.
TEST(TriangleGroups, keep_what_floats_can_not_hold) {
    for (const double size : {1e-60, 1e-40, 1e-30, 1e-20}) {
        TriangleGroups groups;
        groups.add({0, 0, 0}, {size, 0, 0}, {0, size, 0}, 7, 1);
        groups.end_group();
        groups.close();
        bool met = false;
        groups.each_near(GroupRay({{size / 4, size / 4, 1}, {0, 0, -1}}, 1), infinity<double>, 0, 1,
                         [&](std::uint32_t /*object*/) { return met = true; });
        EXPECT_TRUE(met) << size;
    }
}

} // namespace
} // namespace rayscope::test
