#pragma once
// Structural similarity: how alike two pictures look, where a pixel more or less at an edge does not matter.

#include "core/image/image.hpp"

namespace rayscope {

/// Brightness as a screen shows it, 0 to 255, row by row.
struct Luma {
    int width = 0, height = 0;
    std::vector<double> values;
};

/// Of the bytes that write_image puts into a .png, weighted as in Rec. 601.
[[nodiscard]] Luma luma(const Image& image);

/// The same of bytes that are at hand: red, green, blue, row by row.
[[nodiscard]] Luma luma(const std::vector<std::uint8_t>& rgb, int width, int height);

/// Mean SSIM over all windows that fit: 1 for equal pictures, less for others, around 0 for unrelated ones.
/// Gaussian window of 11 × 11, σ = 1.5, K₁ = 0.01, K₂ = 0.03 (Wang, Bovik, Sheikh, Simoncelli 2004, "Image quality
/// assessment: from error visibility to structural similarity"). Both must have one size, at least 11 × 11.
[[nodiscard]] double ssim(const Luma& a, const Luma& b);

} // namespace rayscope
