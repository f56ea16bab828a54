// Guards against lengths that are written into the code: what is large or small in it must follow from the scene.

#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace rayscope::test {
namespace {

// The whole scene, its camera and its lights, as seen from a world in which all lengths are `factor` times as large.
Scene scaled(Scene scene, double factor) {
    const Mat4d matrix = scaling(factor, factor, factor);
    scene.camera.eye *= factor;
    scene.camera.look_at *= factor;
    for (SceneLight& light : scene.lights)
        if (!light.directional) light.position *= factor;
    for (SceneGeneric& generic : scene.generics) generic.matrix = matrix * generic.matrix;
    return scene;
}

std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "chapters"))
        if (entry.path().extension() == ".toml") found.push_back(entry.path());
    return found;
}

RenderResult small_image(const Scene& scene) {
    RenderOptions options;
    options.width = 96;
    options.height = 72;
    return render(make_workbench(scene), options);
}

// Compounds with a matrix of their own would need it conjugated: the shipped ones that have one are left out.
bool scales(const Scene& scene) {
    for (const SceneCompound& compound : scene.compounds)
        if (compound.matrix != Mat4d{1}) return false;
    return true;
}

TEST(Scale, by_a_power_of_two_changes_no_bit_of_an_image) {
    int scenes = 0;
    for (const auto& path : shipped_scenes()) {
        const Scene scene = load_scene(path);
        if (!scales(scene)) continue;
        ++scenes;
        const std::uint64_t expected = hash(small_image(scene).image);
        for (const double factor : {0x1p-20, 0x1p20, 0.5, 0x1p-7})
            EXPECT_EQ(hash(small_image(scaled(scene, factor)).image), expected) << path << " × " << factor;
    }
    EXPECT_GE(scenes, 5);
}

} // namespace
} // namespace rayscope::test
