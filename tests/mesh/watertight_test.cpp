// Guards against light that leaks between triangles: rays aimed at the places where they meet.

#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// From outside of a convex mesh at a vertex or at a point of an edge that faces the ray, and with the inside behind it.
template <Numbers N> void expect_tight(int count, double far) {
    using T = ScalarOf<N>;
    const MeshData data = globe_data(40);
    const Mesh<N> mesh = mesh_of(data).to<N>();
    Random random(7);
    std::vector<MeshCrossing<T>> list;
    for (int i = 0; i < count; ++i) {
        const MeshData::Corners& t = data.triangles[std::size_t(random.below(int(data.triangles.size())))];
        const Vec3d a = data.positions[t[0]], b = data.positions[t[1]];
        const double share = random.below(3) == 0 ? 0 : random.uniform(0, 1);
        const Vec3d target = a + share * (b - a);
        Vec3d origin = target + random.direction() * random.decade(-1, far);
        if (random.below(4) == 0) { // along an axis
            origin = target;
            origin[random.below(3)] *= 3;
        }
        // Well within the cone of directions that lead through the globe.
        if (!(dot(normalized(origin - target), normalized(target)) > 0.3)) continue;
        const Ray<T> ray{as<T>(origin), as<T>(target) - as<T>(origin)};
        mesh.crossings(ray, no_face, list);
        ASSERT_EQ(list.size(), 2U) << hex(Ray<double>{origin, target - origin});
        ASSERT_TRUE(list[0].entering && !list[1].entering);
        const auto first = mesh.closest(ray, {});
        ASSERT_TRUE(first && first->t == list[0].t && first->triangle == list[0].triangle);
    }
}

TEST(Watertight, edges_and_vertices_in_double) { expect_tight<double>(samples(200000), 3); }
TEST(Watertight, edges_and_vertices_in_float) { expect_tight<float>(samples(50000), 1); }
TEST(Watertight, edges_and_vertices_in_long_double) { expect_tight<long double>(samples(20000), 3); }

// What a ray enters it leaves, on any mesh, however it is aimed.
TEST(Watertight, crossings_alternate) {
    const std::vector<MeshData> meshes{globe_data(30, 0.4), joined(cube_data(), cube_data({0.5, 0.2, 0.1})),
                                       joined(globe_data(10, 0.2), cube_data({2, 0, 0}))};
    Random random(8);
    for (int i = 0; i < samples(60000); ++i) {
        const MeshData& data = meshes[std::size_t(i % 3)];
        static const std::vector<Mesh<double>> built{mesh_of(meshes[0]), mesh_of(meshes[1]),
                                                     mesh_of(meshes[2])};
        const auto vertex = [&] {
            return data.positions[std::size_t(random.below(int(data.positions.size())))];
        };
        const Vec3d from = vertex(), to = vertex();
        if (from == to) continue;
        // Through two vertices, or along an edge.
        const Ray<double> ray{from + (to - from) * random.uniform(-3, 3), to - from};
        const auto list = crossings(built[std::size_t(i % 3)], ray);
        ASSERT_EQ(list.size() % 2, 0U) << hex(ray);
        for (std::size_t k = 0; k < list.size(); ++k) {
            ASSERT_EQ(list[k].entering, k % 2 == 0) << hex(ray);
            if (k > 0) {
                ASSERT_LE(list[k - 1].t, list[k].t) << hex(ray);
            }
        }
    }
}

// A needle thinner than the rounding of its corners, and triangles that are none.
TEST(Watertight, slivers) {
    MeshData data = cube_data();
    data.positions.push_back((data.positions[4] + data.positions[6]) / 2.0); // on an edge of triangle 0
    data.triangles[0] = {0, 4, 8};
    data.triangles.push_back({0, 8, 6});
    data.triangles.push_back({4, 6, 8}); // without area: it closes the edge 4 6
    ASSERT_FALSE(find_hole(data));
    const Mesh<double> mesh = mesh_of(data);
    Random random(9);
    for (int i = 0; i < samples(20000); ++i) {
        const Vec3d target{-1, random.uniform(-1, 1), random.coin() ? 1 : random.uniform(-1, 1)};
        const Vec3d origin = target + Vec3d{-random.uniform(0.5, 3), random.uniform(-0.1, 0.1), 0.5};
        const auto list = crossings(mesh, {origin, target - origin});
        ASSERT_EQ(list.size(), 2U);
        ASSERT_TRUE(is_finite(list[0].t) && is_finite(list[1].t));
    }
}

} // namespace
} // namespace rayscope::test
