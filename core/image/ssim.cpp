#include "core/image/ssim.hpp"

#include "core/image/srgb.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace rayscope {
namespace {

constexpr int window_side = 11, window_middle = window_side / 2;

std::array<double, window_side> gaussian() {
    constexpr double sigma = 1.5;
    std::array<double, window_side> weights{};
    double sum = 0;
    for (int i = 0; i < window_side; ++i) {
        const double x = i - window_middle;
        sum += weights[std::size_t(i)] = std::exp(-x * x / (2 * sigma * sigma));
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// The weighted mean around each pixel whose whole window lies in the picture: along rows, then along columns.
Luma blurred(const Luma& picture) {
    static const std::array<double, window_side> weights = gaussian();
    const int width = picture.width - window_side + 1, height = picture.height - window_side + 1;
    const auto mean = [](const double* first, std::size_t stride) {
        double sum = 0;
        for (std::size_t i = 0; i < window_side; ++i) sum += weights[i] * first[i * stride];
        return sum;
    };
    std::vector<double> rows;
    rows.reserve(std::size_t(width) * std::size_t(picture.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x)
            rows.push_back(
                mean(&picture.values[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)], 1));
    Luma result{width, height, {}};
    result.values.reserve(std::size_t(width) * std::size_t(height));
    for (std::size_t i = 0; i < std::size_t(width) * std::size_t(height); ++i)
        result.values.push_back(mean(&rows[i], std::size_t(width)));
    return result;
}

Luma multiplied(const Luma& a, const Luma& b) {
    Luma result = a;
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

double weighted(double red, double green, double blue) { return 0.299 * red + 0.587 * green + 0.114 * blue; }

} // namespace

Luma luma(const std::vector<std::uint8_t>& rgb, int width, int height) {
    Luma result{width, height, {}};
    result.values.reserve(rgb.size() / 3);
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
        result.values.push_back(weighted(rgb[i], rgb[i + 1], rgb[i + 2]));
    return result;
}

Luma luma(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.rgb.size());
    for (const float component : image.rgb) bytes.push_back(srgb_byte(component));
    return luma(bytes, image.width, image.height);
}

double ssim(const Luma& a, const Luma& b) {
    assert(a.width == b.width && a.height == b.height && a.width >= window_side && a.height >= window_side);
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    const Luma mean_a = blurred(a), mean_b = blurred(b);
    const Luma aa = blurred(multiplied(a, a)), bb = blurred(multiplied(b, b)), ab = blurred(multiplied(a, b));
    double sum = 0;
    for (std::size_t i = 0; i < ab.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = aa.values[i] - ma * ma, variance_b = bb.values[i] - mb * mb;
        const double covariance = ab.values[i] - ma * mb;
        sum += (2 * ma * mb + c1) * (2 * covariance + c2) /
               ((ma * ma + mb * mb + c1) * (variance_a + variance_b + c2));
    }
    return sum / double(ab.values.size());
}

} // namespace rayscope
