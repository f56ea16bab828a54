#pragma once
// One number for each pixel, as a picture with its scale.

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/picture.hpp"

#include <string>

namespace rayscope::drawing {

/// Viridis: share 0 is dark, 1 is light.
[[nodiscard]] Rgb heat_colour(double share);

/// Viridis from 0 to `most`, beside a bar that tells the numbers; what is more looks like `most`.
/// Each value is a square of whole pixels.
[[nodiscard]] Raster draw_heat_map(const Map& map, const std::string& title, double most);

/// Where such a scale may end: at the largest value, unless a few outliers would leave all others in the dark.
[[nodiscard]] double end_of_scale(const Map& map);

} // namespace rayscope::drawing
