// Guards against lists in floats that lose what a light sees where floats end.

#include "core/extents/view_rectangle.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(LightLists, round_to_floats_the_right_way_at_any_size) {
    for (const double size : {1e-300, 1e-60, 1e-46, 1e-45, 1e-38, 1.0, 3e38, 4e38, 1e40, 1e300})
        for (const double x : {size, -size}) {
            EXPECT_LE(double(below(x)), x);
            EXPECT_GE(double(above(x)), x);
        }
}

// Balls in a row throw shadows on each other, in a world of a size that no float can hold.
TEST(LightLists, find_the_same_shadows_in_a_world_of_any_size) {
    for (const double size : {1e-100, 1e-60, 1e-46, 1.0, 1e40, 1e100})
        for (const bool directional : {false, true}) {
            SceneBuilder b;
            Camera& camera = b.scene().camera;
            camera.eye = {0, -6 * size, 3 * size};
            camera.look_at = {0, 0, 0};
            camera.up = {0, 0, 1};
            camera.width = camera.height = 48;
            const std::size_t dull = b.material({});
            for (int i = 0; i < 9; ++i)
                b.generic(Sphere<double>{},
                          translation({size * (i % 3 - 1), size * (i / 3 - 1), 0.2 * size * i}) *
                              scaling(0.4 * size),
                          dull);
            SceneLight light;
            light.directional = directional;
            light.position = directional ? normalized(Vec3d{-0.5, 0.4, 1}) : Vec3d{4, -3, 6} * size;
            b.scene().lights.push_back(light);
            const Workbench bench = b.open();
            RenderOptions scan, lists;
            scan.stage = stage_choice("scan");
            lists.stage = stage_choice("light");
            EXPECT_EQ(render(bench, scan).image.rgb, render(bench, lists).image.rgb)
                << size << (directional ? ", a directional light" : ", a point light");
        }
}

// Points so far from all balls that no list was made for them; most of their shadow rays miss the crowd as a whole.
TEST(LightLists, are_of_use_to_rays_from_afar) {
    SceneBuilder b;
    Random random(3);
    const std::size_t dull = b.material(SceneMaterial{});
    for (int i = 0; i < 200; ++i)
        b.generic(Sphere<double>{}, translation(random.in_cube(1e-3)) * scaling(1e-4), dull);
    b.generic(Plane<double>{}, translation({0, 0, -0.01}), dull);
    b.light({0.1, 0.2, 3});
    b.scene().camera.eye = {0, -4, 4};
    b.scene().camera.up = {0, 0, 1};
    b.scene().camera.width = b.scene().camera.height = 24;
    const Workbench bench = b.open();
    RenderOptions scan, lists;
    scan.stage = stage_choice("scan");
    lists.stage = stage_choice("eye=bvh,shadow=light,other=bvh");
    const RenderResult all = render(bench, scan), few = render(bench, lists);
    EXPECT_EQ(all.image.rgb, few.image.rgb);
    EXPECT_LT(few.statistics.counters.objects, all.statistics.counters.objects / 10);
}

} // namespace
} // namespace rayscope::test
