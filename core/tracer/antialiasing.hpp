#pragma once
// Where a pixel needs more than one sample, and how many.

#include "core/image/image.hpp"
#include "core/image/map.hpp"
#include "core/math/box.hpp"
#include "core/tracer/tracer.hpp"

#include <algorithm>
#include <vector>

namespace rayscope {

/// An image as its file shows it.
class ShownImage {
public:
    using Bytes = std::array<std::uint8_t, 3>;

    explicit ShownImage(const Image& image);

    /// Several threads may set pixels of their own.
    void set(int x, int y, const Colour& colour);
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] const Bytes& operator[](std::size_t pixel) const { return bytes_[pixel]; }
    /// Calls pair(pixel, other) once for each two of the pixels, row by row, that touch.
    template <typename Pair> void each_pair(const Pair& pair) const {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                if (x + 1 < width_) pair(place(x, y), place(x + 1, y));
                if (y + 1 == height_) continue;
                for (int other = std::max(x - 1, 0); other <= std::min(x + 1, width_ - 1); ++other)
                    pair(place(x, y), place(other, y + 1));
            }
    }

private:
    [[nodiscard]] std::size_t place(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    int width_, height_;
    std::vector<Bytes> bytes_;
};

/// For each pixel, row by row: 0 where one sample is enough; else how far its colour is from its neighbours', in steps of an
/// image file's bytes, or 1 where only another object or another direction of the surface is seen beside it; in a penumbra
/// as many as that is worth.
using Contrasts = std::vector<std::uint8_t>;

/// @param seen by the ray through each pixel's middle
[[nodiscard]] Contrasts contrasts(const ShownImage& image, const std::vector<FirstSeen>& seen);

/// Of pixels that have one sample still, beside those that have got more just now: what these found, a sliver of an edge or
/// of a highlight, may go on where no ray through a middle meets it.
/// @param refined where it is not 0, a pixel has got more
/// @return nothing where all are even
[[nodiscard]] Contrasts contrasts_beside(const ShownImage& image, const Map& samples,
                                         const Contrasts& refined);

/// The least and the largest of some colours, in each primary.
class ColourSpread {
public:
    explicit ColourSpread(const Colour& first) { add(first); }

    void add(const Colour& colour) { colours_.include(colour); }
    /// Between the two, as an image file shows them.
    [[nodiscard]] int steps() const;

private:
    Box<double> colours_;
};

/// A pixel's colour and how many samples it is the mean of.
struct RefinedPixel {
    Colour colour;
    int samples;
};

/// Contrasts, in steps of an image file's bytes, up to which a pixel has enough with a quarter of the samples, and with a
/// half of them.
struct EnoughSamples {
    int for_quarter = 8, for_half = 24; // measured: not less in any image
};
/// An image's error is that of its sharp edges: what is slight beside them may keep more of its own, as long as that adds no
/// more than a twentieth to the squares of all errors. The error of n samples goes with n^(−3/4) (Mitchell 1996).
[[nodiscard]] EnoughSamples enough_samples(const Contrasts& contrasts);

/// Where a pixel differs little from its neighbours and its samples from each other, a quarter of them tells its colour as
/// well, somewhat more, a half: the error of a mean is a share of what is averaged. Samples that are alike say nothing by
/// themselves: at an edge, all may lie on one side.
/// @param first the sample in the middle
/// @param most at most so many, and all of them where they are too few to stop early
/// @param trace gives another one by its number
template <typename Trace>
[[nodiscard]] RefinedPixel refine(const Colour& first, int contrast, const EnoughSamples& enough, int most,
                                  const Trace& trace) {
    constexpr int fewest = 4;
    RefinedPixel pixel{first, 1};
    ColourSpread spread(first);
    const auto take = [&](int count) {
        for (; pixel.samples < count; ++pixel.samples) {
            const Colour sample = trace(pixel.samples);
            pixel.colour += sample;
            spread.add(sample);
        }
        return std::max(contrast, spread.steps());
    };
    if (most / 4 < fewest || (take(most / 4) > enough.for_quarter && take(most / 2) > enough.for_half))
        take(most);
    pixel.colour /= double(pixel.samples);
    return pixel;
}

} // namespace rayscope
