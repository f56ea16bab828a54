// Guards against two effects that disturb each other: every pair, on one scene.

#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rayscope::test {
namespace {

// A glass ball with a drop in it, a mirror and a floor.
Scene still_life() {
    SceneBuilder b;
    b.scene().camera.eye = {0, -6, 2};
    b.scene().camera.up = {0, 0, 1};
    b.scene().camera.width = 24;
    b.scene().camera.height = 18;
    b.scene().limits.max_depth = 5;
    b.scene().limits.wavelengths = 3;
    b.scene().background = {0.2, 0.3, 0.5};
    b.light({3, -4, 6}, {0.8, 0.8, 0.7}).shadows = false;
    SceneMaterial matt, clear = SceneBuilder::dark(), shiny;
    clear.transmission = Colour{0.8};
    clear.reflection = Colour{0.1};
    clear.speed = 1 / 1.5;
    shiny.specular = Colour{0.5};
    const auto floor = b.material(matt), glass = b.material(clear), mirror = b.material(shiny);
    clear.speed = 1 / 1.33;
    b.generic(Plane<double>{}, translation({0, 0, -1}), floor, "floor");
    b.generic(Sphere<double>{}, Mat4d{1}, glass, "ball");
    b.generic(Sphere<double>{}, scaling(0.4), b.material(clear), "drop", 1);
    b.generic(Cylinder<double>{}, translation({2, 1, 0}), mirror, "post");
    return b.scene();
}

bool finite(const Image& image) {
    return std::ranges::all_of(image.rgb, [](float x) { return std::isfinite(x) && x >= 0; });
}

TEST(Pairs, give_the_same_image_by_every_stage_and_any_number_of_threads) {
    const auto count = effect_names.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i; j < count; ++j) {
            Scene scene = still_life();
            (void)add_effect(Effect(i), scene);
            (void)add_effect(Effect(j), scene);
            const Workbench bench = make_workbench(scene);
            const std::string what =
                std::string(effect_names[i].name) + " and " + std::string(effect_names[j].name);
            RenderOptions options;
            options.threads = 1;
            options.stage = stage_choice("scan");
            const RenderResult result = render(bench, options);
            EXPECT_TRUE(finite(result.image)) << what;
            for (const char* stage : {"extents", "octree", "bvh", "eye=projective,shadow=light,other=bvh"}) {
                options.threads = 3;
                options.stage = stage_choice(stage);
                EXPECT_EQ(hash(render(bench, options).image), hash(result.image)) << what << " by " << stage;
            }
        }
    }
}

TEST(Pairs, taken_away_leave_what_was_there_before) {
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        const auto effect = Effect(i);
        if (effect == Effect::ambient || effect == Effect::diffuse || effect == Effect::refraction ||
            effect == Effect::reflection || effect == Effect::specular || effect == Effect::nested_media)
            continue; // the scene has them
        Scene scene = still_life();
        const auto before = hash(render(make_workbench(scene), RenderOptions{}).image);
        if (!add_effect(effect, scene)) continue;
        if (effect != Effect::shadows) {
            EXPECT_NE(hash(render(make_workbench(scene), RenderOptions{}).image), before)
                << effect_names[i].name;
        }
        take_away(effect, scene);
        if (effect == Effect::fresnel || effect == Effect::patterns) continue; // other constants than before
        EXPECT_EQ(hash(render(make_workbench(scene), RenderOptions{}).image), before) << effect_names[i].name;
    }
}

// A pattern may leave no room for more light, though its mean does.
TEST(Added, coefficients_make_no_light) {
    const Pattern all_or_nothing{Pattern::Kind::checker, Colour{1}, Colour{0}, 0.25, 0};
    for (const Effect effect : {Effect::reflection, Effect::refraction}) {
        SceneBuilder b;
        b.scene().background = Colour{1};
        SceneMaterial m = SceneBuilder::dark();
        (effect == Effect::reflection ? m.transmission : m.reflection) = Colour{0.5};
        (effect == Effect::reflection ? m.patterns.transmission : m.patterns.reflection) = all_or_nothing;
        b.generic(Sphere<double>{}, Mat4d{1}, b.material(m), "ball");
        EXPECT_FALSE(add_effect(effect, b.scene()));
    }
}

TEST(TakenAway, fresnel_leaves_what_light_straight_on_is_reflected_in_the_scenes_own_medium) {
    SceneBuilder b;
    SceneMaterial m = SceneBuilder::dark();
    m.mirror = Mirror::fresnel;
    m.speed = 1 / 1.5;
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(m), "ball");
    b.scene().medium_speed = 1 / 1.5;
    take_away(Effect::fresnel, b.scene());
    EXPECT_EQ(b.scene().materials[0].reflection, Colour{0});
    EXPECT_EQ(b.scene().materials[0].transmission, Colour{1});
}

TEST(Ledger, adds_up_to_the_colour_of_the_sample) {
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        Scene scene = still_life();
        (void)add_effect(Effect(i), scene);
        (void)add_effect(Effect::absorption, scene);
        const Workbench bench = make_workbench(scene);
        for (int x = 0; x < 24; x += 5) {
            const Trace trace = trace_pixel(bench, x, 9);
            const Ledger ledger = ledger_of(trace.rays);
            Colour sum{0};
            for (const auto& [source, light] : ledger.sources) sum += light;
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(sum[c], trace.colour[c], 1e-12) << effect_names[i].name;
                EXPECT_NEAR(ledger.total[c], trace.colour[c], 1e-12);
            }
        }
    }
}

TEST(Ledger, of_dropped_rays_of_single_wavelengths_weighs_what_they_share) {
    SceneBuilder b;
    const auto glass = b.clear(0, 0.5, 1.5);
    b.scene().materials[glass].dispersion = Dispersion::by_abbe_number(1.5, 30);
    b.generic(Sphere<double>{}, Mat4d{1}, glass, "ball");
    b.scene().limits.max_depth = 1;
    b.scene().camera.width = b.scene().camera.height = 16;
    const Ledger ledger = ledger_of(trace_pixel(b.open(), 9, 8).rays);
    const DroppedRays& dropped = ledger.dropped.at({RayKind::refracted, Reason::depth});
    EXPECT_EQ(dropped.count, b.scene().limits.wavelengths);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(dropped.weight[c], 0.25, 1e-12);
}

TEST(Ledger, counts_as_absorbed_what_would_have_arrived) {
    SceneBuilder b;
    SceneMaterial murky = SceneBuilder::dark();
    murky.transmission = Colour{0.9};
    murky.absorption = Colour{2, 0.5, 0};
    b.generic(Cube<double>{}, Mat4d{1}, b.material(murky), "first");
    b.generic(Cube<double>{}, translation({0, 0, 4}), b.material(murky), "second");
    b.scene().background = Colour{1};
    const Ray<double> ray{{0.1, 0.2, -5}, {0, 0, 1}};
    const Ledger with = ledger_of(trace_ray(b.open(), ray).rays);
    for (SceneMaterial& m : b.scene().materials) m.absorption = Colour{0};
    const Ledger without = ledger_of(trace_ray(b.open(), ray).rays);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(with.total[c] + with.absorbed[c], without.total[c], 1e-12);
}

TEST(Ledger, of_dropped_rays_keeps_their_colours) {
    SceneBuilder b;
    SceneMaterial mirror = SceneBuilder::dark();
    mirror.reflection = {0.9, 0.1, 0};
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(mirror), "ball");
    b.scene().limits.max_depth = 0;
    const Ledger ledger = ledger_of(trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}}).rays);
    EXPECT_EQ(ledger.dropped.at({RayKind::reflected, Reason::depth}).weight, mirror.reflection);
}

TEST(Ledger, of_an_image_is_that_of_all_its_samples) {
    Scene scene = still_life();
    scene.camera.samples = 8;
    const Workbench bench = make_workbench(scene);
    const Image image = render(bench, RenderOptions{}).image;
    Colour mean{0};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) mean += image.at(x, y) / double(image.width * image.height);
    const Ledger book = ledger(bench);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(book.total[c], mean[c], 1e-6);
}

TEST(Trace, of_a_sample_is_the_images) {
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        Scene scene = still_life();
        if (Effect(i) == Effect::antialiasing || !add_effect(Effect(i), scene)) continue;
        const Workbench bench = make_workbench(scene);
        const Image image = render(bench, RenderOptions{}).image;
        for (int y = 0; y < image.height; y += 4)
            for (int x = 0; x < image.width; x += 3) {
                const Colour colour = trace_pixel(bench, x, y).colour;
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(float(colour[c]), float(image.at(x, y)[c])) << effect_names[i].name;
            }
    }
}

} // namespace
} // namespace rayscope::test
