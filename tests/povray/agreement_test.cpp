// Our image and POV-Ray's, of the same scene.

#include "core/rayscope.hpp"
#include "tests/povray/povray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

/// Scenes that POV-Ray can't show, and why.
const std::map<std::string, std::string, std::less<>> not_compared = {
    {"flush_holes", "operands share planes, and POV-Ray leaves it to rounding which of them has the face"},
};

std::vector<fs::path> scenes_in(const fs::path& folder, std::string_view extension) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == extension) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

void expect_agreement(const fs::path& path, double least) {
    SCOPED_TRACE(path.filename().string());
    const Workbench bench = open(path);
    const Camera& camera = bench.scene.camera;
    // Small enough to be quick, large enough that an edge's pixels do not count for much.
    const int shrink = std::max(1, (std::max(camera.width, camera.height) + 399) / 400);
    RenderOptions options;
    options.width = camera.width / shrink;
    options.height = camera.height / shrink;
    const Luma ours = luma(render(bench, options).image);
    const Luma theirs =
        render_by_povray(to_povray(bench.scene, bench.world).text, options.width, options.height);
    ASSERT_EQ(theirs.values.size(), ours.values.size());
    const double similarity = ssim(ours, theirs);
    std::cout << "    " << path.stem().string() << ": SSIM " << similarity << '\n';
    EXPECT_GE(similarity, least);
}

TEST(PovrayAgreement, of_shipped_scenes) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const auto scenes = scenes_in(RAYSCOPE_SOURCE_DIR "/chapters", ".toml");
    ASSERT_GT(scenes.size(), 10U);
    for (const fs::path& scene : scenes)
        if (not_compared.find(scene.stem().string()) == not_compared.end()) expect_agreement(scene, 0.98);
}

TEST(PovrayAgreement, of_everything_that_a_scene_can_say) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    for (const fs::path& scene : scenes_in(RAYSCOPE_SOURCE_DIR "/tests/povray/scenes", ".toml"))
        expect_agreement(scene, 0.998);
}

// The Standard Procedural Databases, where they are at hand.
TEST(PovrayAgreement, of_nff_scenes) {
    const char* folder = std::getenv("RAYSCOPE_SPD");
    if (folder == nullptr) GTEST_SKIP() << "RAYSCOPE_SPD names no folder";
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    for (const fs::path& scene : scenes_in(folder, ".nff")) expect_agreement(scene, 0.98);
}

} // namespace
} // namespace rayscope::test
