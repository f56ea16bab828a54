// Our image and POV-Ray's, of the same scene.

#include "core/rayscope.hpp"
#include "tests/povray/povray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <future>
#include <iostream>
#include <map>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

/// Scenes that POV-Ray can't show, and why.
const std::map<std::string, std::string, std::less<>> not_compared = {
    {"ice_water", "its media overlap, and POV-Ray knows the one that a ray entered last"},
    {"flush_holes", "operands share planes, and POV-Ray leaves it to rounding which of them has the face"},
};

std::vector<fs::path> scenes_in(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml" || entry.path().extension() == ".nff")
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

Workbench open_as_it_is(const fs::path& path) { return open(path); }
/// With no interpolated normals: where one turns away from the eye POV-Ray turns it back, which darkens the rims of a coarse
/// shape, and we take the face's own. The export says so.
Workbench open_flat(const fs::path& path) {
    Scene scene = open(path).scene;
    for (SceneGeneric& generic : scene.generics)
        if (const auto* polygon = std::get_if<Polygon<double>>(&generic.shape))
            generic.shape = Polygon<double>(polygon->vertices());
    return make_workbench(scene);
}

/// Small enough to be quick, large enough that an edge's pixels do not count for much.
/// @param longest side of the images, in pixels
double similarity(const Workbench& bench, int longest) {
    const Camera& camera = bench.scene.camera;
    const int shrink = std::max(1, (std::max(camera.width, camera.height) + longest - 1) / longest);
    RenderOptions options;
    options.width = camera.width / shrink;
    options.height = camera.height / shrink;
    options.samples = 1; // POV-Ray is asked for one
    const Luma ours = luma(render(bench, options).image);
    const Luma theirs =
        render_by_povray(to_povray(bench.scene, bench.world).text, options.width, options.height);
    return theirs.values.size() == ours.values.size() ? ssim(ours, theirs) : 0;
}

// All at once, since POV-Ray mostly sleeps while it starts.
template <typename Open>
void expect_agreement(const std::vector<fs::path>& scenes, const Open& open_scene, double least,
                      int longest = 400) {
    std::vector<std::future<double>> found;
    found.reserve(scenes.size());
    for (const fs::path& scene : scenes)
        found.push_back(
            std::async(std::launch::async, [&] { return similarity(open_scene(scene), longest); }));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const double ssim = found[i].get();
        std::cout << "    " << scenes[i].stem().string() << ": SSIM " << ssim << '\n';
        EXPECT_GE(ssim, least) << scenes[i];
    }
}

TEST(PovrayAgreement, of_shipped_scenes) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    auto scenes = scenes_in(RAYSCOPE_SOURCE_DIR "/chapters");
    ASSERT_GT(scenes.size(), 10U);
    std::erase_if(scenes, [](const fs::path& scene) { return not_compared.contains(scene.stem().string()); });
    expect_agreement(scenes, open_as_it_is, 0.98);
}

TEST(PovrayAgreement, of_everything_that_a_scene_can_say) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    expect_agreement(scenes_in(RAYSCOPE_SOURCE_DIR "/tests/povray/scenes"), open_as_it_is, 0.999);
}

// The Standard Procedural Databases, where they are at hand.
TEST(PovrayAgreement, of_nff_scenes) {
    const char* folder = std::getenv("RAYSCOPE_SPD");
    if (folder == nullptr) GTEST_SKIP() << "RAYSCOPE_SPD names no folder";
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    expect_agreement(scenes_in(folder), open_flat, 0.98, 512);
}

} // namespace
} // namespace rayscope::test
