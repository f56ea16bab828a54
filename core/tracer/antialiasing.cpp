#include "core/tracer/antialiasing.hpp"

#include "core/image/srgb.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace rayscope {
namespace {

// Of the surface's directions: beyond about 18 degrees an edge is seen.
constexpr double least_cosine = 0.95;
// Two neighbours that are farther apart make a visible step.
constexpr int largest_step = 3;
// A penumbra is noise, though of smaller steps: as if it differed by so many, measured.
constexpr std::uint8_t penumbra_contrast = 25;

int steps_between(const ShownImage::Bytes& a, const ShownImage::Bytes& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int(a[i]) - int(b[i])));
    return most;
}

bool is_same_surface(const FirstSeen& a, const FirstSeen& b) {
    return a.object == b.object && (a.object == none || dot(a.normal, b.normal) > least_cosine);
}

} // namespace

ShownImage::ShownImage(const Image& image) : width_(image.width), height_(image.height) {
    bytes_.reserve(std::size_t(width_) * std::size_t(height_));
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) bytes_.push_back(srgb_bytes(image.at(x, y)));
}

void ShownImage::set(int x, int y, const Colour& colour) { bytes_[place(x, y)] = srgb_bytes(colour); }

int ColourSpread::steps() const { return steps_between(srgb_bytes(colours_.low), srgb_bytes(colours_.high)); }

Contrasts contrasts(const ShownImage& image, const std::vector<FirstSeen>& seen) {
    Contrasts contrasts(image.size());
    image.each_pair([&](std::size_t a, std::size_t b) {
        const int steps = steps_between(image[a], image[b]);
        if (steps <= largest_step && is_same_surface(seen[a], seen[b])) return;
        for (const std::size_t pixel : {a, b})
            contrasts[pixel] = std::max(contrasts[pixel], std::uint8_t(std::max(steps, 1)));
    });
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].penumbra) contrasts[i] = std::max(contrasts[i], penumbra_contrast);
    return contrasts;
}

Contrasts contrasts_beside(const ShownImage& image, const Map& samples, const Contrasts& refined) {
    Contrasts contrasts;
    image.each_pair([&](std::size_t a, std::size_t b) {
        if ((refined[a] == 0) == (refined[b] == 0)) return;
        const std::size_t other = refined[a] == 0 ? a : b;
        const int steps = steps_between(image[a], image[b]);
        if (samples.values[other] > 1 || steps <= largest_step) return;
        contrasts.resize(image.size());
        contrasts[other] = std::max(contrasts[other], std::uint8_t(steps));
    });
    return contrasts;
}

EnoughSamples enough_samples(const Contrasts& contrasts) {
    std::array<double, 256> squares{}; // of all pixels with such a contrast
    for (const std::uint8_t contrast : contrasts) squares[contrast] += double(contrast) * contrast;
    const auto up_to = [&](int contrast) {
        return std::accumulate(squares.begin(), squares.begin() + contrast + 1, 0.0);
    };
    // What a quarter and a half of the samples add to the square of an error.
    const double quarter = std::pow(4, 1.5) - 1, half = std::pow(2, 1.5) - 1;
    EnoughSamples enough;
    for (EnoughSamples next = enough; next.for_half < 255;) {
        next = {next.for_quarter + 1, next.for_half + 3};
        const double by_quarter = up_to(next.for_quarter);
        const double added = quarter * by_quarter + half * (up_to(next.for_half) - by_quarter);
        if (added > up_to(255) / 20) break;
        enough = next;
    }
    return enough;
}

} // namespace rayscope
