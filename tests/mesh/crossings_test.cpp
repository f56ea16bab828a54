// Where lines go into meshes and out of them.

#include "core/generics/cube.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rayscope::test {
namespace {

std::vector<double> ts(const std::vector<MeshCrossing<double>>& list) {
    std::vector<double> result;
    for (const auto& c : list) result.push_back(c.t);
    return result;
}
using List = std::vector<double>;

TEST(MeshCrossings, known_rays) {
    const Mesh<double> cube = mesh_of(cube_data());
    EXPECT_EQ(ts(crossings(cube, {{0.3, 0.2, 5}, {0, 0, -1}})), (List{4, 6}));
    EXPECT_EQ(ts(crossings(cube, {{0.3, 0.2, 0}, {0, 0, -2}})), (List{-0.5, 0.5}));
    EXPECT_EQ(ts(crossings(cube, {{0.3, 0.2, -5}, {0, 0, -1}})), (List{-6, -4}));
    EXPECT_EQ(ts(crossings(cube, {{0, 0, 5}, {0, 0, -1}})), (List{4, 6})); // along both diagonals
    EXPECT_EQ(ts(crossings(cube, {{1.5, 0, 5}, {0, 0, -1}})), List{});
    EXPECT_EQ(ts(crossings(cube, {{5, 5, 5}, {-1, -1, -1}})), (List{4, 6})); // through two corners
    const auto list = crossings(cube, {{0.3, 0.2, 5}, {0, 0, -1}});
    EXPECT_TRUE(list[0].entering);
    EXPECT_FALSE(list[1].entering);
    EXPECT_EQ(list[0].triangle / 2, 5U);
}

TEST(MeshCrossings, of_a_cube_are_the_generic_cubes) {
    const Mesh<double> mesh = mesh_of(cube_data());
    const Cube<double> cube;
    Random random(1);
    for (int i = 0; i < samples(20000); ++i) {
        const Ray<double> ray = random.towards_unit_cube(random.decade(-1, 3));
        const auto list = crossings(mesh, ray);
        const auto expected = cube.intervals(ray);
        ASSERT_EQ(list.size(), std::size_t(2 * expected.count)) << hex(ray);
        for (int k = 0; k < expected.count; ++k) {
            const double off = 16 * epsilon<double> * (length(ray.origin) + 3) / length(ray.direction);
            ASSERT_NEAR(list[0].t, expected.items[0].enter, off) << hex(ray);
            ASSERT_NEAR(list[1].t, expected.items[0].exit, off) << hex(ray);
        }
    }
}

// Overlapping parts are one: where they do, there is no boundary. So is the seam of parts that touch.
TEST(MeshCrossings, parts_unite) {
    const Ray<double> ray{{0.1, 0.2, -5}, {0, 0, 1}};
    EXPECT_EQ(ts(crossings(mesh_of(joined(cube_data(), cube_data({0, 0, 1}))), ray)), (List{4, 7}));
    EXPECT_EQ(ts(crossings(mesh_of(joined(cube_data(), cube_data({0, 0, 2}))), ray)), (List{4, 8}));
    EXPECT_EQ(ts(crossings(mesh_of(joined(cube_data(), cube_data({0, 0, 4}))), ray)), (List{4, 6, 8, 10}));
    MeshData hollow = cube_data({0, 0, 0}, 0.5);
    for (MeshData::Corners& t : hollow.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(ts(crossings(mesh_of(joined(cube_data(), hollow)), ray)), (List{4, 4.5, 5.5, 6}));
}

TEST(MeshCrossings, surface_is_met_once_each_time) {
    const Mesh<double> bowl = mesh_of(bowl_data(16));
    EXPECT_FALSE(bowl.solid);
    const auto up = crossings(bowl, {{0.05, 0.03, 5}, {0, 0, -1}});
    ASSERT_EQ(up.size(), 1U);
    EXPECT_FALSE(up[0].entering); // from within
    EXPECT_EQ(crossings(bowl, {{-5, 0.03, -0.3}, {1, 0, 0}}).size(), 2U);
    std::vector<MeshCrossing<double>> left;
    bowl.crossings({{0.05, 0.03, 5}, {0, 0, -1}}, int(up[0].triangle), left);
    EXPECT_TRUE(left.empty());
}

TEST(MeshCrossings, start_on_a_triangle_is_zero) {
    const Mesh<double> cube = mesh_of(cube_data());
    std::vector<MeshCrossing<double>> list;
    cube.crossings({{0.3, 0.2, 1 + 1e-9}, {0, 0, -1}},
                   int(crossings(cube, {{0.3, 0.2, 5}, {0, 0, -1}})[0].triangle), list);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[0].t, 0);
    EXPECT_NEAR(list[1].t, 2, 1e-8);
}

// The query of the hot path looks no farther than it must: it says what the whole list says.
TEST(MeshCrossings, closest_is_the_first_of_the_list) {
    const std::vector<Mesh<double>> meshes{mesh_of(cube_data()), mesh_of(globe_data(24, 0.3)),
                                           mesh_of(bowl_data(20)),
                                           mesh_of(joined(cube_data(), cube_data({0.5, 0.5, 0.5}))),
                                           mesh_of(joined(cube_data(), cube_data({2, 0, 0})))};
    Random random(2);
    for (int i = 0; i < samples(40000); ++i) {
        const Mesh<double>& mesh = meshes[std::size_t(random.below(int(meshes.size())))];
        Ray<double> ray = random.towards_unit_cube(random.decade(-1, 1));
        const MeshData& data = mesh.triangles().data();
        if (random.coin()) // at a vertex
            ray.direction =
                data.positions[std::size_t(random.below(int(data.positions.size())))] - ray.origin;
        const Range<double> range{0, random.coin() ? infinity<double> : random.uniform(0, 2)};
        const auto found = mesh.closest(ray, range);
        const auto list = crossings(mesh, ray);
        const auto first =
            std::find_if(list.begin(), list.end(), [&](const auto& c) { return range.contains(c.t); });
        ASSERT_EQ(found.has_value(), first != list.end()) << hex(ray);
        if (!found) continue;
        ASSERT_EQ(found->t, first->t) << hex(ray);
        ASSERT_EQ(found->triangle, first->triangle) << hex(ray);
        ASSERT_EQ(found->entering, first->entering) << hex(ray);
    }
}

TEST(MeshCrossings, value_is_the_distance) {
    const Mesh<double> cube = mesh_of(cube_data());
    EXPECT_DOUBLE_EQ(cube.value({0, 0, 0.75}), -0.25);
    EXPECT_DOUBLE_EQ(cube.value({0, 0, 3}), 2);
    EXPECT_DOUBLE_EQ(cube.value({4, 5, 0}), 5);
    Random random(3);
    const Mesh<double> globe = mesh_of(globe_data(20));
    for (int i = 0; i < samples(2000); ++i) {
        const Vec3d p = random.in_cube(2);
        EXPECT_NEAR(globe.value(p), length(p) - 1, 0.05);
    }
}

} // namespace
} // namespace rayscope::test
