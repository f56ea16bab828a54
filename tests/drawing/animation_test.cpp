// A walk as pictures: one for each ray, in one file or many.

#include "visualizer/drawing/animation.hpp"

#include "tests/drawing/bowl.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace rayscope::test {
namespace {

using namespace rayscope::drawing;

constexpr PictureSize smallest{480, 320};

/// A ray that a mirror sends back once.
struct Mirrored {
    Workbench bench;
    Trace trace;
};
Mirrored mirrored(int max_depth) {
    SceneBuilder b;
    const auto mirror = b.clear(0.9, 0, 1);
    b.generic(Plane<double>{}, translation({0, 0, -1}), mirror, "front");
    b.generic(Plane<double>{}, translation({0, 0, 1}) * scaling(1, 1, -1), mirror, "back");
    b.scene().limits.max_depth = max_depth;
    b.scene().limits.min_weight = 0;
    Workbench bench = make_workbench(b.scene());
    Trace trace = trace_ray(bench, {{0, 0, 0.5}, {0.1, 0, -1}});
    return {std::move(bench), std::move(trace)};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Animation, holds_a_frame_for_each_ray) {
    const TemporaryFolder folder;
    const auto [bench, trace] = mirrored(3);
    ASSERT_EQ(trace.rays.size(), 4U);
    write_animation(bench, trace, folder.path() / "walk.webp", smallest);
    std::ifstream file(folder.path() / "walk.webp", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 4), "RIFFWEBP");
    EXPECT_EQ(count(bytes, "ANMF"), 4U);
}

TEST(Animation, is_also_pictures_with_numbers_as_long_as_the_last) {
    const TemporaryFolder folder;
    const auto [bench, trace] = mirrored(10);
    const auto files = write_all_pictures(bench, trace, folder.path() / "walk.png", smallest);
    ASSERT_EQ(files.size(), 11U);
    EXPECT_EQ(files.front(), folder.path() / "walk-00.png");
    EXPECT_EQ(files.back(), folder.path() / "walk-10.png");
    for (const auto& path : files) EXPECT_TRUE(exists(path));
}

TEST(Animation, of_too_many_rays_is_refused_before_anything_is_written) {
    const TemporaryFolder folder;
    Mirrored all = mirrored(0);
    all.trace.rays.resize(std::size_t(most_frames) + 1, all.trace.rays.front());
    EXPECT_THROW(write_animation(all.bench, all.trace, folder.path() / "walk.webp", smallest), InputError);
    EXPECT_THROW(write_all_pictures(all.bench, all.trace, folder.path() / "walk.png", smallest), InputError);
    EXPECT_TRUE(is_empty(folder.path()));
}

} // namespace
} // namespace rayscope::test
