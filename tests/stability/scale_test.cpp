// Guards against lengths that are written into the code: what is large or small in it must follow from the scene.

#include "tests/stability/moved.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace rayscope::test {
namespace {

std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "chapters"))
        if (entry.path().extension() == ".toml") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

constexpr int width = 96, height = 72;

RenderResult small_image(const Workbench& bench) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    return render(bench, options);
}

// The same world seen from one in which all lengths are `factor` times as large.
Motion by(double factor) { return {scaling(factor), factor, false}; }

TEST(Scale, by_a_power_of_two_changes_no_bit_of_an_image) {
    for (const auto& path : shipped_scenes()) {
        const Scene scene = load_scene(path);
        const std::uint64_t expected = hash(small_image(make_workbench(scene)).image);
        for (const double factor : {0x1p-20, 0x1p20, 0.5, 0x1p-7})
            EXPECT_EQ(hash(small_image(make_workbench(moved(scene, by(factor)))).image), expected)
                << path << " × " << factor;
    }
    EXPECT_GE(shipped_scenes().size(), 14U);
}

// A float's rounding, and as much again of what was rounded to it.
bool differ(const Image& a, const Image& b, std::size_t pixel) {
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        if (std::abs(a.rgb[i] - b.rgb[i]) > 2 * epsilon<float> * std::max(1.0F, std::abs(a.rgb[i])))
            return true;
    return false;
}

// Lists the pixels that differ, each with the t of its eye ray's hit in both worlds.
void expect_within_bounds(const std::filesystem::path& path, double factor) {
    const Motion motion = by(factor);
    const Workbench here = open(path), there = make_workbench(moved(here.scene, motion));
    const Image image = small_image(here).image, scaled = small_image(there).image;
    const EyeRays eye(here.scene.camera, width, height), scaled_eye(there.scene.camera, width, height);
    Comparison comparison(here.world, there.world, motion);
    // With less effort, of the pixels that do not differ only some.
    const auto every = std::size_t(std::max(1.0, std::round(1 / effort())));
    int differing = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(y) * width + std::size_t(x);
            const bool differing_here = differ(image, scaled, pixel);
            if (!differing_here && pixel % every != 0) continue;
            const Agreement a =
                comparison.compare(eye.through(x + 0.5, y + 0.5), scaled_eye.through(x + 0.5, y + 0.5));
            EXPECT_EQ(a.wrong, "") << path << " × " << factor << " pixel " << x << ", " << y;
            if (!differing_here) continue;
            ++differing;
            std::printf("%s × %g pixel (%d, %d): colour %.9g, %.9g; t %.17g ± %.3g, %.17g ± %.3g%s\n",
                        path.filename().c_str(), factor, x, y, double(image.rgb[3 * pixel]),
                        double(scaled.rgb[3 * pixel]), a.t, a.bound, a.moved_t, a.moved_bound,
                        a.parted > 0 ? ", parts further on" : "");
        }
    EXPECT_LE(differing, width * height / 100) << path;
}

TEST(Scale, by_a_million_moves_hits_within_their_bounds_only) {
    for (const auto& path : shipped_scenes())
        for (const double factor : {1e-6, 1e6}) expect_within_bounds(path, factor);
}

} // namespace
} // namespace rayscope::test
