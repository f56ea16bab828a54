#pragma once
// Where a pixel needs more than one sample.

#include "core/image/image.hpp"
#include "core/tracer/tracer.hpp"

#include <vector>

namespace rayscope {

/// Whether a person could tell two colours apart, as they are shown.
[[nodiscard]] bool differ(const Colour& a, const Colour& b);

/// The pixels beside which another object, another direction of the surface or another colour is seen.
/// @param seen by the ray through each pixel's middle, row by row
[[nodiscard]] std::vector<bool> uneven_pixels(const Image& image, const std::vector<FirstSeen>& seen);

/// The mean of up to `most` samples of a pixel. A few come first; where they are alike, they are all.
/// @param first the sample in the middle
/// @param trace gives another one by its number
/// @param taken how many samples there are, in the end
template <typename Trace>
[[nodiscard]] Colour mean_of_samples(const Colour& first, int most, const Trace& trace, int& taken) {
    constexpr int few = 8; // evenly spread, they miss no more than an eighth
    Colour sum = first;
    bool alike = true;
    for (taken = 1; taken < most; ++taken) {
        if (taken == few && alike) break;
        const Colour next = trace(taken);
        alike = alike && !differ(next, first);
        sum += next;
    }
    return sum / double(taken);
}

/// The mean of all samples of a pixel.
template <typename Trace>
[[nodiscard]] Colour mean_of_all_samples(const Colour& first, int count, const Trace& trace) {
    Colour sum = first;
    for (int sample = 1; sample < count; ++sample) sum += trace(sample);
    return sum / double(count);
}

} // namespace rayscope
