// A picture needs no display, is the same each time, and shows something in whatever scene.

#include "visualizer/drawing/picture.hpp"

#include "tests/drawing/bowl.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>
#include <set>

namespace rayscope::test {
namespace {

using namespace rayscope::drawing;

constexpr PictureSize small{800, 450};

/// Pixels that clearly differ from the ground, in the part of the picture where the view is.
std::size_t marked_pixels(const Raster& raster) {
    std::size_t marked = 0;
    for (int y = raster.height / 8; y < raster.height * 5 / 8; ++y)
        for (int x = 0; x < raster.width * 3 / 5; ++x) {
            const std::uint8_t* p =
                &raster.bytes[(std::size_t(y) * std::size_t(raster.width) + std::size_t(x)) * 3];
            if (std::abs(p[0] - sky.red) + std::abs(p[1] - sky.green) + std::abs(p[2] - sky.blue) > 60)
                ++marked;
        }
    return marked;
}

TEST(Picture, needs_no_display_and_has_the_size_asked_for) {
    unsetenv("DISPLAY");
    const TemporaryFolder folder;
    const auto path = folder.path() / "bowl.png";
    write_picture(bowl(), bowl_trace(), path, {{900, 500}, none});
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    std::array<int, 3> size{};
    reader->GetOutput()->GetDimensions(size.data());
    EXPECT_EQ(size[0], 900);
    EXPECT_EQ(size[1], 500);
}

TEST(Picture, is_the_same_each_time_and_differs_by_the_current_ray) {
    const Trace trace = bowl_trace();
    const Raster first = draw_picture(bowl(), trace, {small, 3});
    EXPECT_GT(marked_pixels(first), 1000U);
    EXPECT_EQ(draw_picture(bowl(), trace, {small, 3}).bytes, first.bytes);
    EXPECT_NE(draw_picture(bowl(), trace, {small, 4}).bytes, first.bytes);
    EXPECT_NE(draw_picture(bowl(), trace, {small, none}).bytes, first.bytes);
}

TEST(Picture, shows_a_scene_of_any_size_and_place_alike) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        SceneBuilder builder;
        Mat4d matrix{scale};
        matrix[3] = {1000 * scale, 0, 0, 1};
        builder.generic(Sphere<double>{}, matrix, builder.glowing(Colour{0.5}), "ball");
        const Workbench bench = make_workbench(builder.scene());
        const Trace trace = trace_ray(bench, {{1000 * scale, 0.3 * scale, 6 * scale}, {0, 0, -1}});
        EXPECT_NE(trace.rays.front().find<BoundaryChosen>(), nullptr);
        EXPECT_GT(marked_pixels(draw_picture(bench, trace, {small, none})), 1000U) << scale;
    }
}

TEST(Picture, shows_a_ray_that_meets_nothing) {
    SceneBuilder builder;
    builder.generic(Sphere<double>{}, Mat4d{1}, builder.glowing(Colour{0.5}), "ball");
    const Workbench bench = make_workbench(builder.scene());
    EXPECT_GT(marked_pixels(draw_picture(bench, trace_ray(bench, {{0, 3, 5}, {0, 0, -1}}), {small, none})),
              200U);
    EXPECT_GT(marked_pixels(draw_picture(bench, trace_ray(bench, {{9e8, 3, 5}, {0, 1, 0}}), {small, none})),
              100U);
    const Workbench empty = make_workbench(SceneBuilder().scene());
    EXPECT_GT(marked_pixels(draw_picture(empty, trace_ray(empty, {{0, 0, 0}, {1, 0, 0}}), {small, none})),
              100U);
}

TEST(Picture, refuses_a_ray_that_does_not_exist) {
    const Trace trace = bowl_trace();
    EXPECT_THROW(static_cast<void>(draw_picture(bowl(), trace, {small, int(trace.rays.size())})), InputError);
    EXPECT_THROW(static_cast<void>(draw_picture(bowl(), Trace{}, {small, none})), InputError);
}

} // namespace
} // namespace rayscope::test
