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

/// The mean of a pixel's samples. All of them: where the first few are alike, the others still find slivers, and what
/// an early end saves at an edge it loses there in exactness (measured: a decibel).
/// @param first the sample in the middle
/// @param trace gives another one by its number
template <typename Trace>
[[nodiscard]] Colour mean_of_samples(const Colour& first, int count, const Trace& trace) {
    Colour sum = first;
    for (int sample = 1; sample < count; ++sample) sum += trace(sample);
    return sum / double(count);
}

} // namespace rayscope
