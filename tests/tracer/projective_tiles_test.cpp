#include "core/tracer/stage_set.hpp"
#include "tests/support/random.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

Workbench cloud(int balls, double radius) {
    Random random(static_cast<std::uint64_t>(balls));
    SceneBuilder b;
    const auto dull = b.glowing({1, 1, 1});
    for (int i = 0; i < balls; ++i)
        b.generic(Sphere<double>{}, translation(random.in_cube(1)) * scaling(radius), dull);
    return b.open();
}

int tile_of(int balls, int width, int height) {
    const Workbench bench = cloud(balls, 0.01);
    const EyeRays eye_rays(bench.scene.camera, width, height);
    const auto view = screen_view(bench.world, eye_rays, width, height);
    return ProjectiveExtents<double>(bench.world, view, width, height).tile_pixels();
}

TEST(ProjectiveTiles, are_smaller_where_many_objects_share_a_small_screen) {
    EXPECT_EQ(tile_of(10, 64, 64), 8);
    EXPECT_EQ(tile_of(512, 64, 64), 8); // 64 tiles: one for each eighth of them
    EXPECT_EQ(tile_of(2000, 64, 64), 4);
    EXPECT_EQ(tile_of(2000, 16, 16), 1);
}

// Of every size, on a screen that no size divides.
TEST(ProjectiveTiles, list_what_their_pixels_show) {
    constexpr int width = 37, height = 21;
    for (const int balls : {20, 200, 600, 2000, 6000}) {
        const Workbench bench = cloud(balls, 1 / std::sqrt(balls));
        const EyeRays eye_rays(bench.scene.camera, width, height);
        const StageKind kind = StageKind::projective;
        const StageSet stages(bench.world, {kind, kind, StageKind::bvh}, Screen{eye_rays, width, height});
        const Scan<double> scan(bench.world);
        Work<double> work;
        NullRecorder recorder;
        const Leaving<double> nothing;
        int hits = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Ray<double> ray = eye_rays.through(x + 0.5, y + 0.5);
                const auto found = stages.closest({RayKind::eye, x, y, none}, ray, Range<double>{0}, nothing,
                                                  work, recorder);
                const auto expected = scan.closest(ray, Range<double>{0}, nothing, work, recorder);
                ASSERT_EQ(bool(found), bool(expected)) << balls << " balls, pixel " << x << ' ' << y;
                if (!found) continue;
                ++hits;
                ASSERT_EQ((*found).t, (*expected).t) << balls << " balls, pixel " << x << ' ' << y;
                ASSERT_EQ((*found).object, (*expected).object);
            }
        EXPECT_GT(hits, 50);
    }
}

} // namespace
} // namespace rayscope::test
