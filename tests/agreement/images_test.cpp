// Guards against a rung of the ladder that changes a picture: all give the same image, bit for bit.

#include "tests/agreement/random_scene.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace rayscope::test {
namespace {

std::vector<StageChoice> choices() {
    std::vector<StageChoice> result;
    for (const Rung& rung : rungs) result.push_back(rung.choice);
    result.push_back(stage_choice("eye=projective,shadow=light,other=octree"));
    result.push_back(stage_choice("eye=projective,shadow=light,other=bvh"));
    return result;
}

void expect_same_images(const Workbench& bench, int width, int height, const std::string& what) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.stage = StageChoice{};
    const Image expected = render(bench, options).image;
    for (const StageChoice& choice : choices()) {
        options.stage = choice;
        const Image found = render(bench, options).image;
        int different = 0;
        for (std::size_t i = 0; i < expected.rgb.size(); ++i)
            different +=
                std::bit_cast<std::uint32_t>(found.rgb[i]) != std::bit_cast<std::uint32_t>(expected.rgb[i])
                    ? 1
                    : 0;
        ASSERT_EQ(different, 0) << what << ": " << described(choice);
    }
    options.stage = std::nullopt;
    ASSERT_EQ(hash(render(bench, options).image), hash(expected)) << what << ": best";
}

TEST(Images, of_shipped_scenes_are_the_same_on_all_rungs) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYSCOPE_SOURCE_DIR "/chapters")) {
        if (entry.path().extension() != ".toml") continue;
        ++scenes;
        expect_same_images(open(entry.path()), 72, 54, entry.path().string());
        if (HasFatalFailure()) return;
    }
    EXPECT_GE(scenes, 14);
}

// Looked at from so near that the margin of its box is seen: rounding finds hits beside an object that is pressed flat.
TEST(Images, of_an_edge_of_what_a_matrix_distorts_are_the_same_on_all_rungs) {
    SceneBuilder b;
    const double angle = 30.517,
                 edge = std::cos(angle * std::numbers::pi / 180) + std::sin(angle * std::numbers::pi / 180);
    b.generic(Cube<double>{}, scaling(1, 1, 1e-6) * rotation({0, 1, 0}, angle), b.clear(0.3, 0, 1));
    b.light({3, 4, 5});
    b.scene().camera.eye = {edge, 0, 10};
    b.scene().camera.look_at = {edge, 0, 0};
    for (const double view : {1e-9, 1e-8, 1e-7}) {
        b.scene().camera.field_of_view = view;
        expect_same_images(b.open(), 64, 48, "edge");
    }
}

// Cameras and lights anywhere: inside objects, among them, far away, infinitely far.
void compare_random_scenes(int count, int width, int height) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(count); ++seed) {
        Random random(seed);
        Scene scene = random_scene(random, 1 + random.below(120));
        for (SceneMaterial& m : scene.materials) m.diffuse = Colour{0.5};
        const double distance = random.decade(-1, 2);
        scene.camera.eye = random.in_cube(distance);
        scene.camera.look_at = scene.camera.eye + random.direction();
        scene.camera.field_of_view = random.uniform(5, 160);
        scene.limits.max_depth = 3;
        for (int i = 0; i < 3; ++i) {
            SceneLight light;
            light.position = random.in_cube(random.decade(-1, 2.5));
            light.directional = random.below(4) == 0;
            if (light.directional) light.position = normalized(light.position);
            scene.lights.push_back(light);
        }
        expect_same_images(make_workbench(scene), width, height, "seed " + std::to_string(seed));
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Images, of_random_scenes_are_the_same_on_all_rungs) { compare_random_scenes(samples(40), 40, 30); }
TEST(ImagesFull, of_random_scenes_are_the_same_on_all_rungs) {
    compare_random_scenes(samples(100), 160, 120);
}

} // namespace
} // namespace rayscope::test
