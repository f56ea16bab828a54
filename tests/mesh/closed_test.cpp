// Which meshes enclose a volume, and where the others are open.

#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Closed, cube_and_globe_are) {
    EXPECT_FALSE(find_hole(cube_data()));
    EXPECT_FALSE(find_hole(globe_data(12)));
    EXPECT_FALSE(find_hole(joined(cube_data(), cube_data({5, 0, 0}))));
    EXPECT_DOUBLE_EQ(signed_volume(cube_data()), 6 * 8);
}

TEST(Closed, hole_is_named_by_its_edge) {
    MeshData data = cube_data();
    data.triangles.erase(data.triangles.begin()); // 0 4 6
    const auto hole = find_hole(data);
    ASSERT_TRUE(hole);
    EXPECT_EQ(hole->from, 0U);
    EXPECT_EQ(hole->to, 4U);
    EXPECT_EQ(hole->along + hole->against, 1);
    EXPECT_TRUE(find_hole(bowl_data(8)));
}

TEST(Closed, triangle_that_runs_the_wrong_way_is_a_hole) {
    MeshData data = cube_data();
    std::swap(data.triangles[5][0], data.triangles[5][1]);
    const auto hole = find_hole(data);
    ASSERT_TRUE(hole);
    EXPECT_EQ(hole->along + hole->against, 2);
    EXPECT_NE(hole->along, hole->against);
}

TEST(Closed, vertices_at_one_place_are_one) {
    MeshData apart; // each triangle has its own, as files with colours have
    const MeshData data = cube_data();
    for (const MeshData::Corners& t : data.triangles) {
        const auto first = std::uint32_t(apart.positions.size());
        for (const std::uint32_t corner : t) apart.positions.push_back(data.positions[corner]);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_FALSE(find_hole(apart));
    apart.positions[7].x += 0x1p-52;
    EXPECT_TRUE(find_hole(apart));
}

// Two cubes that share an edge: four triangles there, two each way.
TEST(Closed, parts_may_share_an_edge) { EXPECT_FALSE(find_hole(joined(cube_data(), cube_data({2, 2, 0})))); }

// What a million triangles may cost: shared vertices, and at worst three vertices with normals for each.
TEST(Closed, memory) {
    const MeshData shared = globe_data(200);
    MeshData apart;
    for (const MeshData::Corners& t : shared.triangles) {
        const auto first = std::uint32_t(apart.positions.size());
        for (const std::uint32_t corner : t) {
            apart.positions.push_back(shared.positions[corner]);
            apart.normals.push_back(shared.normals[corner]);
        }
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    const auto each = [](MeshData data) {
        for (auto* list : {&data.triangles, &data.triangle_normals}) list->shrink_to_fit();
        data.positions.shrink_to_fit();
        data.normals.shrink_to_fit();
        const TriangleMesh mesh(std::move(data));
        return double(mesh.bytes()) / double(mesh.size());
    };
    EXPECT_LT(each(shared), 100);
    EXPECT_LT(each(apart), 200);
}

TEST(Closed, what_is_inside_out_is_turned) {
    MeshData data = cube_data();
    for (MeshData::Corners& t : data.triangles) std::swap(t[0], t[1]);
    const Mesh<double> mesh = mesh_of(data);
    EXPECT_TRUE(mesh.contains({0, 0, 0}));
    EXPECT_GT(dot(mesh.normal({}, 0), Vec3d(-1, 0, 0)), 0);
}

} // namespace
} // namespace rayscope::test
