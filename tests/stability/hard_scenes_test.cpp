// Guards against pictures with specks, acne and skins: the scenes of the accuracy chapter, each made of one hard case.

#include "core/accuracy/colour_difference.hpp"
#include "core/scene/build.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace rayscope::test {
namespace {

constexpr int side = 128;

template <Numbers N> Image image_of(const Scene& scene) {
    RenderOptions options;
    options.width = options.height = side;
    return render(build<N>(scene), scene.camera, options).image;
}

// Pixels that visibly differ.
int damaged(const Image& image, const Image& reference) {
    int count = 0;
    const auto colour = [](const Image& from, std::size_t i) {
        return glm::clamp(Colour{from.rgb[i], from.rgb[i + 1], from.rgb[i + 2]}, 0.0, 1.0);
    };
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        count += ciede2000(lab_of(colour(image, i)), lab_of(colour(reference, i))) > 1 ? 1 : 0;
    return count;
}

TEST(HardScenes, are_clean_in_double_and_damaged_by_the_schoolbook_in_float) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(RAYSCOPE_SOURCE_DIR) /
                                                                 "chapters" / "07_accuracy")) {
        if (entry.path().extension() != ".toml") continue;
        ++scenes;
        const Scene scene = load_scene(entry.path());
        const Image reference = image_of<long double>(scene);
        EXPECT_EQ(damaged(image_of<double>(scene), reference), 0) << entry.path();
        EXPECT_GT(damaged(image_of<Textbook<float>>(scene), reference), side * side / 100) << entry.path();
    }
    EXPECT_EQ(scenes, 6);
}

} // namespace
} // namespace rayscope::test
