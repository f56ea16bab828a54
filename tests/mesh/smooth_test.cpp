// Interpolated normals: near those of the curved surface that is meant, and no way for light through the flat one.

#include "core/scene/read_nff.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

SceneMaterial shiny() {
    SceneMaterial m;
    m.name = "shiny";
    m.ambient = Colour{0};
    m.diffuse = Colour{1};
    m.reflection = Colour{0.5};
    return m;
}

double smooth_error(const MeshData& data) {
    SceneBuilder b;
    b.generic(mesh_of(data), Mat4d{1}, b.material(shiny()));
    const Workbench bench = make_workbench(b.scene());
    Random random(12);
    double smooth = 0, flat = 0;
    for (int i = 0; i < samples(2000); ++i) {
        const Ray<double> ray{random.direction() * 4.0, {0, 0, 0}};
        const Trace trace = trace_ray(bench, {ray.origin, random.in_cube(0.5) - ray.origin});
        const auto* hit = trace.rays[0].find<BoundaryChosen>();
        if (hit == nullptr) return infinity<double>;
        const bool is_front = dot(hit->normal, trace.rays[0].start().direction) < 0;
        smooth = maximum(smooth, length((is_front ? hit->normal : -hit->normal) - normalized(hit->point)));
        const auto* triangle = trace.rays[0].find<TriangleHit>();
        const auto& mesh = std::get<Mesh<double>>(bench.world.solids[0].shape);
        const Vec3d face = normalized(mesh.normal({}, triangle->triangle)), out = normalized(hit->point);
        flat = maximum(flat, length((dot(face, out) < 0 ? -face : face) - out));
    }
    EXPECT_GT(flat, 0.04); // the test would see it
    return smooth;
}

TEST(Smooth, normals_of_a_globe_are_nearly_a_spheres) { EXPECT_LT(smooth_error(globe_data(60)), 0.01); }

// Programs differ in which way they wind, and in which side normals look to; some wind one mesh both ways.
TEST(Smooth, normals_are_turned_to_the_side_that_is_seen_however_faces_are_wound) {
    for (const std::size_t wound_backwards : {0U, 1U, 3U}) // none; all; every third
        for (const bool inward : {false, true}) {
            MeshData data = globe_data(60);
            if (inward)
                for (Vec3<float>& n : data.normals) n = -n;
            for (auto* list : {&data.triangles, &data.triangle_normals})
                for (std::size_t i = 0; i < list->size(); ++i)
                    if (wound_backwards != 0 && i % wound_backwards == 0)
                        std::swap((*list)[i][1], (*list)[i][2]);
            EXPECT_LT(smooth_error(data), 0.01) << wound_backwards << inward;
        }
}

// From a hundredth of the least to the largest size that files may have: the square of an area would be no number.
TEST(Smooth, normals_do_not_depend_on_the_size_of_a_mesh) {
    for (const int power : {-1000, -600, -300, 300}) {
        MeshData data = globe_data(12);
        const Mesh<double> unit = mesh_of(data);
        const double size = std::ldexp(1.0, power);
        for (Vec3d& p : data.positions) p *= size;
        const Mesh<double> scaled = mesh_of(data);
        for (int triangle = 0; triangle < int(scaled.triangles().size()); ++triangle) {
            const auto& corner = unit.triangles().data().triangles[std::size_t(triangle)];
            Vec3d middle{0};
            for (const auto i : corner) middle += unit.triangles().data().positions[i] / 3.0;
            const auto close = [&](const Vec3d& a, const Vec3d& b) {
                EXPECT_NEAR(length(normalized(a) - normalized(b)), 0, 1e-12) << power << ' ' << triangle;
            };
            close(scaled.normal(middle * size, triangle), unit.normal(middle, triangle));
            close(scaled.shading_normal(middle * size, triangle), unit.shading_normal(middle, triangle));
        }
    }
}

// A mirrored ray that starts on the outside stays there, and light behind the triangle does not arrive.
TEST(Smooth, nothing_leaks_through_a_coarse_globe) {
    SceneBuilder b;
    b.generic(mesh_of(globe_data(8)), Mat4d{1}, b.material(shiny()));
    Scene& scene = b.scene();
    SceneLight light;
    light.directional = true;
    light.position = {0, 0, 1};
    scene.lights.push_back(light);
    scene.background = Colour{1};
    const Workbench bench = make_workbench(scene);
    const auto& mesh = std::get<Mesh<double>>(bench.world.solids[0].shape);
    Random random(13);
    int bent = 0;
    for (int i = 0; i < samples(3000); ++i) {
        const Vec3d origin = random.direction() * 3.0;
        const Trace trace = trace_ray(bench, {origin, random.direction() * 0.99 - origin});
        for (const TracedRay& ray : trace.rays) {
            const auto* hit = ray.find<BoundaryChosen>();
            if (hit == nullptr) continue;
            ASSERT_TRUE(hit->entering) << hex(origin.x); // never seen from within
            const Vec3d face = normalized(mesh.normal({}, ray.find<TriangleHit>()->triangle));
            const auto* reflected = ray.find<Reflected>();
            if (reflected != nullptr) {
                ASSERT_GE(dot(reflected->direction, face), -1e-12);
                bent += length(face - hit->normal) > 0.01 ? 1 : 0;
            }
            const auto* lit = ray.find<LightLit>();
            ASSERT_NE(lit, nullptr);
            if (face.z < 0) {
                ASSERT_EQ(lit->diffuse, Colour{0});
            }
        }
    }
    EXPECT_GT(bent, 0);
}

// The patch of the databases: its corners' normals, between them interpolated; bent ones are cut.
TEST(Smooth, nff_patches) {
    const std::string head =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\nf 1 1 1 1 0 1 0 0\n";
    const std::string corners = "0 0 0 -1 -1 2\n2 0 0 1 -1 2\n2 2 0 1 1 2\n0 2 0 -1 1 2\n";
    const Workbench bench = make_workbench(parse_nff(head + "pp 4\n" + corners, "p.nff"));
    const auto normal_at = [&](double x, double y) {
        return trace_ray(bench, {{x, y, 5}, {0, 0, -1}}).rays[0].find<BoundaryChosen>()->normal;
    };
    EXPECT_NEAR(length(normal_at(1e-9, 1e-9) - normalized(Vec3d{-1, -1, 2})), 0, 1e-8);
    EXPECT_NEAR(length(normal_at(1, 1) - Vec3d{0, 0, 1}), 0, 1e-12);
    EXPECT_NEAR(length(normal_at(1, 1e-9) - normalized(Vec3d{0, -1, 2})), 0, 1e-8);
    const Scene bent =
        parse_nff(head + "pp 4\n0 0 0 -1 -1 2\n2 0 0 1 -1 2\n2 2 0.5 1 1 2\n0 2 0 -1 1 2\n", "p.nff");
    EXPECT_EQ(bent.generics.size(), 2U);
    EXPECT_TRUE(bent.warnings.empty());
    EXPECT_TRUE(std::get<Polygon<double>>(bent.generics[1].shape).smooth());
}

} // namespace
} // namespace rayscope::test
