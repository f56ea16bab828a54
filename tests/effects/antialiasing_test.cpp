// Guards against samples where nothing differs, and against steps where something does.

#include "core/tracer/antialiasing.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

SceneBuilder ball_on_nothing(int size) {
    SceneBuilder b;
    b.scene().camera.width = b.scene().camera.height = size;
    b.scene().background = Colour{0};
    b.generic(Sphere<double>{}, Mat4d{1}, b.glowing({1, 1, 1}), "ball");
    return b;
}

TEST(Samples, are_taken_at_edges_alone) {
    SceneBuilder b = ball_on_nothing(64);
    b.scene().camera.samples = 16;
    const RenderResult result = render(b.open(), RenderOptions{});
    int even = 0, refined = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int taken = int(result.samples.at(x, y));
            (taken == 1 ? even : refined) += 1;
            EXPECT_TRUE(taken >= 1 && taken <= 16) << taken;
            const double value = result.image.at(x, y).x;
            if (taken == 1) {
                EXPECT_TRUE(value == 0 || value == 1) << x << ' ' << y;
            }
        }
    EXPECT_GT(refined, 100);
    EXPECT_GT(even, 6 * refined);
    EXPECT_EQ(result.statistics.counters.rays[0], [&] {
        std::uint64_t sum = 0;
        for (const float taken : result.samples.values) sum += std::uint64_t(taken);
        return sum;
    }());
}

TEST(Samples, each_can_be_traced_again_alone_and_their_mean_is_the_pixel) {
    SceneBuilder b = ball_on_nothing(32);
    b.scene().camera.samples = 16;
    const Workbench bench = b.open();
    const RenderResult result = render(bench, RenderOptions{});
    int mixed = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const int taken = int(result.samples.at(x, y));
            double sum = 0;
            for (int s = 0; s < taken; ++s) sum += trace_pixel(bench, x, y, 0, 0, s).colour.x;
            EXPECT_FLOAT_EQ(float(sum / taken), float(result.image.at(x, y).x));
            mixed += sum > 0 && sum < taken ? 1 : 0;
        }
    EXPECT_GT(mixed, 30);
}

TEST(Samples, the_first_ones_of_each_power_of_two_fill_the_pixel_evenly) {
    constexpr std::uint32_t middle = 1U << 31U;
    for (const std::uint32_t count : {4U, 16U, 64U}) {
        const auto cells = std::uint32_t(std::sqrt(count));
        std::vector<int> hits(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const SquarePoint p = sobol(i, middle, middle);
            ++hits[std::size_t(std::uint32_t(p.y * cells) * cells + std::uint32_t(p.x * cells))];
        }
        for (const int h : hits) EXPECT_EQ(h, 1) << count;
    }
    EXPECT_EQ(sobol(0, middle, middle).x, 0.5);
    EXPECT_EQ(sobol(0, middle, middle).y, 0.5);
}

TEST(Samples, cover_as_much_of_an_edge_pixel_as_the_ball_does) {
    SceneBuilder coarse = ball_on_nothing(32), fine = ball_on_nothing(32 * 8);
    coarse.scene().camera.samples = 64;
    const Image smooth = render(coarse.open(), RenderOptions{}).image,
                exact = render(fine.open(), RenderOptions{}).image;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            double sum = 0;
            for (int i = 0; i < 64; ++i) sum += exact.at(8 * x + i % 8, 8 * y + i / 8).x;
            // Along a diagonal edge Sobol's points stand in rows: one of them falls to one side as a whole.
            EXPECT_NEAR(smooth.at(x, y).x, sum / 64, 7.5 / 64) << x << ' ' << y;
        }
}

TEST(Samples, share_what_a_map_shows_of_their_light_as_they_share_the_light) {
    SceneBuilder b;
    b.scene().camera.width = b.scene().camera.height = 8;
    b.scene().background = Colour{1};
    b.scene().limits.max_depth = 2;
    SceneMaterial glass = SceneBuilder::dark();
    glass.mirror = Mirror::fresnel;
    glass.transmission = Colour{1};
    glass.speed = 1 / 1.5;
    glass.dispersion = Dispersion::by_abbe_number(1.5, 30);
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(glass), "ball");
    const Workbench bench = b.open();
    RenderOptions options;
    options.heat = Heat::dropped;
    options.samples = 16;
    const RenderResult result = render(bench, options);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const Colour colour = result.image.at(x, y);
            EXPECT_NEAR(double(result.heat.at(x, y)) + (colour.x + colour.y + colour.z) / 3, 1, 1e-6);
        }
}

TEST(Samples, have_their_mean_in_the_middle_of_the_pixel) {
    const EyeRays eye_rays(Camera{}, 64, 64);
    for (const int count : {1, 4, 8, 16, 64}) {
        Vec3d sum{0};
        for (int sample = 0; sample < count; ++sample) {
            const Vec3d d = eye_rays.of({20, 30, sample}).direction; // through a plane at distance 1
            const Vec3d ahead = eye_rays.through(32, 32).direction;
            sum += d / dot(d, ahead);
        }
        const Vec3d middle = eye_rays.through(20.5, 30.5).direction;
        EXPECT_LT(length(normalized(sum) - middle), 1e-15) << count;
    }
}

// A rod so thin and so flat that the rays through the middles meet it in some columns alone.
TEST(Samples, follow_an_edge_to_where_no_middle_sees_it) {
    SceneBuilder b;
    b.scene().camera.eye = {0, 0, 10};
    b.scene().camera.look_at = {0, 0, 0};
    b.scene().camera.up = {0, 1, 0};
    b.scene().camera.width = b.scene().camera.height = 64;
    b.scene().camera.samples = 16;
    b.scene().background = Colour{0};
    const double pixel = 2 * std::tan(b.scene().camera.field_of_view * std::numbers::pi / 360) * 10 / 64;
    const Mat4d rod = translation({0, 0.3 * pixel, 0}) *
                      rotation({0, 0, 1}, std::atan(2.0 / 64) * 180 / std::numbers::pi) *
                      scaling(100, 0.15 * pixel, 0.01);
    b.generic(Cube<double>{}, rod, b.glowing({1, 1, 1}), "rod");
    const RenderResult result = render(b.open(), RenderOptions{});
    RenderOptions once;
    once.samples = 1;
    const RenderResult middles = render(b.open(), once);
    int seen = 0, followed = 0;
    for (int x = 1; x < 63; ++x) {
        bool middle = false, any = false;
        for (int y = 0; y < 64; ++y) {
            middle = middle || middles.image.at(x, y).x > 0;
            any = any || result.image.at(x, y).x > 0;
        }
        seen += middle ? 1 : 0;
        followed += any ? 1 : 0;
    }
    EXPECT_LT(seen, 40);
    EXPECT_EQ(followed, 62);
}

TEST(Samples, are_fewer_where_there_is_little_to_tell) {
    const auto taken = [](int contrast, double most, int count) {
        return refine(Colour{0.5}, contrast, {}, count,
                      [&](int sample) { return Colour{0.5 + most * (sample % 2)}; })
            .samples;
    };
    EXPECT_EQ(taken(4, 0, 16), 4);
    EXPECT_EQ(taken(16, 0, 16), 8);
    EXPECT_EQ(taken(64, 0, 16), 16); // an edge that all samples so far lie on one side of
    EXPECT_EQ(taken(4, 0.3, 16), 16);
    EXPECT_EQ(taken(4, 0, 64), 16);
    EXPECT_EQ(taken(1, 0, 12), 12); // too few to leave any out
    EXPECT_EQ(taken(1, 0, 2), 2);
}

TEST(Samples, are_fewer_beside_sharp_edges_and_not_without_them) {
    const auto all_of = [](int contrast) { return Contrasts(1000, std::uint8_t(contrast)); };
    // Where all edges are alike, none is slight but for those that always are.
    for (const int contrast : {100, 255}) EXPECT_LT(enough_samples(all_of(contrast)).for_half, contrast);
    EXPECT_EQ(enough_samples(all_of(20)).for_quarter, 8);
    EXPECT_EQ(enough_samples(all_of(20)).for_half, 24);
    Contrasts mixed = all_of(255);
    mixed.insert(mixed.end(), 1000, 20);
    const EnoughSamples enough = enough_samples(mixed);
    EXPECT_GE(enough.for_quarter, 20);
    EXPECT_LT(enough.for_half, 255);
    // What ends early adds no more than a twentieth to the squares of all errors.
    double added = 0, all = 0;
    for (const std::uint8_t c : mixed) {
        const double square = double(c) * c;
        all += square;
        added += c <= enough.for_quarter ? 7 * square : c <= enough.for_half ? 1.83 * square : 0;
    }
    EXPECT_LE(added, all / 20);
}

TEST(Samples, are_taken_in_a_penumbra_though_its_steps_are_small) {
    SceneMaterial matt = SceneBuilder::dark();
    matt.diffuse = Colour{0.02}; // the whole shadow is a few steps deep
    SceneBuilder b;
    SceneLight& lamp = b.light({0, 0, 8});
    lamp.area.shape = LightArea::Shape::sphere;
    lamp.area.radius = 1;
    lamp.area.samples = 16;
    b.generic(Plane<double>{}, Mat4d{1}, b.material(matt), "floor");
    b.generic(Sphere<double>{}, translation({0, 0, 3}), b.material(matt), "ball");
    b.scene().camera.eye = {0, -7, 4};
    b.scene().camera.look_at = {0, 0, 0.2};
    b.scene().camera.up = {0, 0, 1};
    b.scene().camera.width = b.scene().camera.height = 48;
    const LightArea area = lamp.area;
    const auto refined = [&](const LightArea& of_lamp) {
        b.scene().lights[0].area = of_lamp;
        b.scene().camera.samples = 16;
        const RenderResult result = render(b.open(), RenderOptions{});
        return std::ranges::count_if(result.samples.values, [](float taken) { return taken > 1; });
    };
    EXPECT_GT(refined(area), refined(LightArea{}) + 100);
}

} // namespace
} // namespace rayscope::test
