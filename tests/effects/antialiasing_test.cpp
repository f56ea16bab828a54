// Guards against samples where nothing differs, and against steps where something does.

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

} // namespace
} // namespace rayscope::test
