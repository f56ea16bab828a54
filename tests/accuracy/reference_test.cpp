#include "core/accuracy/light_bound.hpp"
#include "core/accuracy/measure.hpp"
#include "core/rayscope.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace rayscope::test {
namespace {

// A glass ball before a mirror, over a floor that glows.
Scene glass_and_mirror() {
    SceneBuilder b;
    b.generic(Sphere<double>{}, Mat4d{1}, b.clear(0.1, 0.85, 1.5), "ball");
    b.generic(Plane<double>{}, translation({0, 0, -3}), b.clear(0.9, 0, 1), "mirror");
    b.generic(Sphere<double>{}, translation({1.5, 0.4, 0}) * scaling(0.3, 0.3, 0.3),
              b.glowing({1, 0.6, 0.2}));
    b.scene().background = {0.3, 0.4, 0.5};
    b.scene().limits.max_depth = 9;
    b.scene().limits.min_weight = 0;
    return b.scene();
}

ReferenceOptions small() {
    ReferenceOptions options;
    options.width = 12;
    options.height = 10;
    options.limits = {12, 0.001, 1000};
    options.identity = "glass and mirror";
    return options;
}

TEST(Reference, is_the_recursions_image_where_nothing_is_cut) {
    const Scene scene = glass_and_mirror();
    ReferenceOptions options = small();
    options.limits = {scene.limits.max_depth, scene.limits.min_weight, 100000};
    const Reference reference = make_reference(scene, options);
    ASSERT_TRUE(reference.complete());
    const auto measured =
        measure(scene, {{{}, scene.limits.max_depth, scene.limits.min_weight}}, reference, {});
    ASSERT_EQ(measured.size(), 1U);
    EXPECT_EQ(measured[0].error.wrong_pixels, 0U);
    EXPECT_LT(measured[0].error.relative_rmse, 1e-7); // floats in the image
    EXPECT_LT(measured[0].error.t_max, 1e-13);
}

// Fewer rays lose light, and never more than is said.
TEST(Reference, what_is_missing_lies_within_the_uncertainty) {
    const Scene scene = glass_and_mirror();
    ReferenceOptions options = small();
    options.limits = {64, 1e-9, 100000};
    const Reference whole = make_reference(scene, options);
    for (const ReferenceLimits limits : {ReferenceLimits{64, 1e-9, 3}, {2, 1e-9, 1000}, {64, 0.2, 1000}}) {
        options.limits = limits;
        const Reference cut = make_reference(scene, options);
        double missing = 0;
        for (std::size_t i = 0; i < whole.samples.size(); ++i) {
            const Colour less = whole.samples[i].colour - cut.samples[i].colour;
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(less[c], -1e-12) << i;
                EXPECT_LE(less[c], cut.uncertainty[i] + 1e-12) << i;
                missing = maximum(missing, less[c]);
            }
        }
        EXPECT_GT(missing, 0) << limits.max_rays;
    }
}

TEST(Reference, goes_on_where_it_was_stopped) {
    const Scene scene = glass_and_mirror();
    const TemporaryFolder folder;
    ReferenceOptions options = small();
    const Reference whole = make_reference(scene, options);

    options.cache = folder.path();
    std::atomic<bool> stop = false;
    options.stop = &stop;
    options.progress = [&](double share) { stop = share > 0.5; };
    const Reference half = make_reference(scene, options);
    EXPECT_FALSE(half.complete());
    EXPECT_GT(half.samples.size(), 0U);

    stop = false;
    double first = 1;
    options.progress = [&](double share) { first = minimum(first, share); };
    const Reference rest = make_reference(scene, options);
    ASSERT_TRUE(rest.complete());
    EXPECT_GT(first, 0.5); // what was there was not made again
    for (std::size_t i = 0; i < whole.samples.size(); ++i) {
        ASSERT_EQ(rest.samples[i].colour, whole.samples[i].colour);
        ASSERT_EQ(rest.samples[i].lost, whole.samples[i].lost);
        ASSERT_EQ(rest.samples[i].first.object, whole.samples[i].first.object);
        ASSERT_EQ(rest.samples[i].first.t, whole.samples[i].first.t);
    }
}

TEST(Reference, a_spoilt_file_in_the_cache_is_replaced) {
    const Scene scene = glass_and_mirror();
    const TemporaryFolder folder;
    ReferenceOptions options = small();
    options.cache = folder.path();
    const Reference whole = make_reference(scene, options);
    const auto file = std::filesystem::directory_iterator(folder.path())->path();
    const auto size = std::filesystem::file_size(file);
    for (const std::uintmax_t length : {std::uintmax_t(0), std::uintmax_t(9), size / 2, size - 1}) {
        std::filesystem::resize_file(file, length);
        const Reference again = make_reference(scene, options);
        ASSERT_TRUE(again.complete());
        EXPECT_EQ(again.samples[50].colour, whole.samples[50].colour);
        EXPECT_EQ(std::filesystem::file_size(file), size);
    }
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(std::streamoff(size / 4));
    bytes.put('\x55').put('\x55').put('\x55');
    bytes.close();
    const Reference again = make_reference(scene, options);
    EXPECT_EQ(again.samples[50].colour, whole.samples[50].colour);
    EXPECT_EQ(again.samples[29].colour, whole.samples[29].colour);
    EXPECT_EQ(again.samples[30].colour, whole.samples[30].colour);
}

// Else a reference in the cache would be taken for that of another shape.
TEST(ContentHash, changes_with_a_mesh_that_the_scene_takes_from_another_file) {
    const TemporaryFolder folder;
    const auto scene = folder.path() / "scene.toml", mesh = folder.path() / "part.obj";
    std::ofstream(scene) << "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n\n[materials.m]\ndiffuse = 1\n\n"
                            "[generics.part]\nshape = \"mesh\"\nfile = \"part.obj\"\nmaterial = \"m\"\n";
    const auto hash_with = [&](const char* corner) {
        std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv " << corner << "\nf 1 2 3\n";
        return content_hash(scene, open(scene).scene);
    };
    const std::string first = hash_with("0 1 0");
    EXPECT_NE(hash_with("0 1 0.25"), first);
    EXPECT_EQ(hash_with("0 1 0"), first);
}

TEST(LightBound, is_that_of_a_furnace) {
    WorldBase world;
    world.background = Colour{1};
    Material m;
    m.reflection = Colour{0.5};
    m.transmission = Colour{0.5};
    world.materials.push_back(m);
    EXPECT_EQ(light_bound(world, 64), Colour{1}); // what arrives is what there is
    world.materials[0].ambient = Colour{0.25};
    world.ambient = Colour{2};
    world.materials[0].reflection = Colour{0.25};
    EXPECT_EQ(light_bound(world, 64), Colour{2}); // 0.5 / (1 − 0.75)
    world.materials[0].reflection = Colour{0.5};
    EXPECT_EQ(light_bound(world, 3), Colour{2.5}); // 1 + 3 · 0.5
}

} // namespace
} // namespace rayscope::test
