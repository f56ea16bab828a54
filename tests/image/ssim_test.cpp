// SSIM against its definition, written out window by window.

#include "core/image/ssim.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rayscope::test {
namespace {

constexpr double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;

Luma flat(int width, int height, double value) {
    return {width, height, std::vector<double>(std::size_t(width * height), value)};
}

// One window of 11 × 11 around each pixel that has one.
double by_definition(const Luma& a, const Luma& b) {
    double total = 0;
    int windows = 0;
    for (int y = 5; y + 5 < a.height; ++y)
        for (int x = 5; x + 5 < a.width; ++x, ++windows) {
            double weight = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
            const auto each = [&](const auto& use) {
                for (int j = -5; j <= 5; ++j)
                    for (int i = -5; i <= 5; ++i) {
                        const auto at = std::size_t(y + j) * std::size_t(a.width) + std::size_t(x + i);
                        use(std::exp(-(i * i + j * j) / 4.5), a.values[at], b.values[at]);
                    }
            };
            each([&](double w, double p, double q) { weight += w, ma += w * p, mb += w * q; });
            ma /= weight, mb /= weight;
            each([&](double w, double p, double q) {
                va += w / weight * (p - ma) * (p - ma);
                vb += w / weight * (q - mb) * (q - mb);
                cov += w / weight * (p - ma) * (q - mb);
            });
            total += (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
        }
    return total / windows;
}

TEST(Ssim, is_the_mean_over_all_windows) {
    Random random(1);
    Luma a = flat(19, 14, 0), b = a;
    for (double& value : a.values) value = random.uniform(0, 255);
    for (std::size_t i = 0; i < b.values.size(); ++i) b.values[i] = 0.6 * a.values[i] + random.uniform(0, 90);
    EXPECT_NEAR(ssim(a, b), by_definition(a, b), 1e-9);
    EXPECT_LT(ssim(a, b), 0.95);
    EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
    EXPECT_NEAR(ssim(a, a), 1, 1e-12);
}

TEST(Ssim, of_flat_pictures_compares_their_brightness) {
    const double expected = (2 * 100 * 140 + c1) / (100 * 100 + 140 * 140 + c1);
    EXPECT_NEAR(ssim(flat(11, 11, 100), flat(11, 11, 140)), expected, 1e-12);
}

TEST(Ssim, luma_is_what_a_screen_shows) {
    Image image(3, 1);
    image.set(0, 0, {1, 0, 0});
    image.set(1, 0, {0, 7, 0});          // clamped
    image.set(2, 0, Colour{0.21404114}); // half of what a screen can
    const Luma shown = luma(image);
    ASSERT_EQ(shown.values.size(), 3U);
    EXPECT_NEAR(shown.values[0], 0.299 * 255, 1e-9);
    EXPECT_NEAR(shown.values[1], 0.587 * 255, 1e-9);
    EXPECT_NEAR(shown.values[2], 128, 1e-9);
    EXPECT_EQ(luma(std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 128, 128, 128}, 3, 1).values,
              shown.values);
}

} // namespace
} // namespace rayscope::test
