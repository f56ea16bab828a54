// Meshes in scenes: as operands, as surfaces that can't be, and alone.

#include "core/bvh/bvh.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/read_toml.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

constexpr const char* cube_obj =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7\n";

constexpr const char* scene_text = R"([materials.m]
[generics.outer]
shape = "mesh"
file = "cube.obj"
[generics.hole]
shape = "sphere"
transform = [{ scale = 1.2 }]
[compounds.c]
is = "outer - hole"
material = "m"
)";

class MeshScenes : public testing::Test {
protected:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_.path() / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    [[nodiscard]] std::string error_in(const std::string& name) const {
        try {
            (void)load_scene(path(name));
            return "no error";
        } catch (const InputError& error) {
            std::string text = error.what();
            while (text.find(folder_.path().string()) != std::string::npos)
                text.erase(text.find(folder_.path().string()), folder_.path().string().size() + 1);
            return text;
        }
    }

private:
    TemporaryFolder folder_;
};

TEST_F(MeshScenes, cube_minus_sphere_is_that_of_the_generic_cube) {
    write("cube.obj", cube_obj);
    write("mesh.toml", scene_text);
    const Workbench mesh = open(path("mesh.toml"));
    SceneBuilder b;
    b.operand("outer", Cube<double>{});
    b.operand("hole", Sphere<double>{1.2});
    b.compound("c", "outer-hole", b.clear(0, 0, 1));
    const Workbench generic = make_workbench(b.scene());
    Random random(11);
    for (int i = 0; i < samples(20000); ++i) {
        const Ray<double> ray = random.towards_unit_cube(random.decade(-1, 1));
        const auto found = spans(mesh, ray)[0], expected = spans(generic, ray)[0];
        ASSERT_EQ(found.size(), expected.size()) << hex(ray);
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double off = 1e-12 * (1 + length(ray.origin)) / length(ray.direction);
            ASSERT_NEAR(found[k].enter.t, expected[k].enter.t, off) << hex(ray);
            ASSERT_NEAR(found[k].exit.t, expected[k].exit.t, off) << hex(ray);
            ASSERT_EQ(found[k].enter.surface.solid, expected[k].enter.surface.solid) << hex(ray);
        }
    }
}

TEST_F(MeshScenes, hole_is_an_error_that_names_it) {
    std::string open_cube = cube_obj;
    open_cube.erase(open_cube.find("f 5 6 8 7\n"));
    write("cube.obj", open_cube);
    write("mesh.toml", scene_text);
    EXPECT_EQ(
        error_in("mesh.toml"),
        "mesh.toml:9:7: 'outer' has a hole at the edge from vertex 5 (-1, -1, 1) to vertex 6 (1, -1, 1): 1 "
        "triangle ends there, where each face needs another that runs along the edge the other way; only a "
        "closed mesh can be an operand");
}

TEST_F(MeshScenes, errors) {
    write("mesh.toml", scene_text);
    EXPECT_EQ(error_in("mesh.toml"), "mesh.toml:4:8: mesh 'cube.obj': there is no such file");
    write("cube.obj", "v 0 0\n");
    EXPECT_EQ(error_in("mesh.toml"), "cube.obj:1:1: expected 3 to 7 numbers, found 2");
    write("mesh.toml", "[generics.a]\nshape = \"mesh\"\nfile = \"a.stl\"\n");
    EXPECT_EQ(error_in("mesh.toml"),
              "mesh.toml:3:8: mesh 'a.stl': not a mesh: its name must end in .obj or .ply");
    write("mesh.toml", "[generics.a]\nshape = \"mesh\"\n");
    EXPECT_NE(error_in("mesh.toml").find("mesh.toml:1:"), std::string::npos);
    write("mesh.toml", "[generics.a]\nshape = \"cube\"\nfile = \"a.obj\"\n");
    EXPECT_NE(error_in("mesh.toml").find("mesh.toml:3:"), std::string::npos);
}

TEST_F(MeshScenes, file_is_in_memory_once) {
    write("cube.obj", cube_obj);
    write("mesh.toml", "[materials.m]\n[generics.a]\nshape=\"mesh\"\nfile=\"cube.obj\"\nmaterial=\"m\"\n"
                       "[generics.b]\nshape=\"mesh\"\nfile=\"cube.obj\"\nmaterial=\"m\"\n");
    const Workbench bench = open(path("mesh.toml"));
    const auto& mesh = [&](std::size_t i) -> const TriangleMesh& {
        return std::get<Mesh<double>>(bench.world.solids[i].shape).triangles();
    };
    EXPECT_EQ(&mesh(0), &mesh(1));
}

TEST_F(MeshScenes, alone_beside_what_has_no_end_needs_no_tree_but_its_own) {
    write("cube.obj", cube_obj);
    const std::string lone =
        "[materials.m]\n[generics.a]\nshape=\"mesh\"\nfile=\"cube.obj\"\nmaterial=\"m\"\n"
        "[generics.floor]\nshape=\"plane\"\nmaterial=\"m\"\n";
    write("lone.toml", lone);
    write("two.toml", lone + "[generics.ball]\nshape=\"sphere\"\nmaterial=\"m\"\n");
    const Workbench lone_bench = open(path("lone.toml")), two_bench = open(path("two.toml"));
    const Bvh<double> one(lone_bench.world), two(two_bench.world);
    EXPECT_EQ(one.statistics().nodes, 0U);
    EXPECT_EQ(one.statistics().apart, 2U);
    EXPECT_GT(two.statistics().nodes, 0U);
    EXPECT_EQ(two.statistics().apart, 1U);
}

TEST_F(MeshScenes, alone_is_framed_and_its_trace_names_the_triangle) {
    write("cube.obj", cube_obj);
    const Workbench bench = open(path("cube.obj"));
    const Image image = render(bench).image;
    const auto is_background = [&](int x, int y) {
        const float* rgb = &image.rgb[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
        return Vec3<float>{rgb[0], rgb[1], rgb[2]} == as<float>(bench.scene.background);
    };
    for (int i = 0; i < image.width; ++i) { // a square: nothing reaches its sides
        EXPECT_TRUE(is_background(i, 0) && is_background(i, image.height - 1) && is_background(0, i) &&
                    is_background(image.width - 1, i));
    }
    EXPECT_FALSE(is_background(image.width / 2, image.height / 2));
    const Trace trace = trace_ray(bench, {{0.5, 0.25, 5}, {0, 0, -1}});
    const auto* hit = trace.rays[0].find<TriangleHit>();
    ASSERT_NE(hit, nullptr);
    EXPECT_EQ(hit->triangle / 2, 5);
    const std::array<int, 3> corners{hit->corner_a, hit->corner_b, hit->corner_c};
    const auto& positions = std::get<Mesh<double>>(bench.world.solids[0].shape).triangles().data().positions;
    Vec3d p{0};
    for (int i = 0; i < 3; ++i) p += hit->shares[i] * positions[std::size_t(corners[std::size_t(i)] - 1)];
    EXPECT_NEAR(length(p - Vec3d(0.5, 0.25, 1)), 0, 1e-15);
}

} // namespace
} // namespace rayscope::test
