#pragma once
// How far an image is from the reference.

#include "core/accuracy/reference.hpp"
#include "core/image/image.hpp"
#include "core/image/map.hpp"

#include <optional>

namespace rayscope {

/// A pixel that is not finite counts as black.
struct ImageError {
    std::size_t wrong_pixels = 0; ///< in which another object is hit first, or none instead of one
    double t_max = 0, t_rms = 0;  ///< error of the first hit's t where the object is right: world length
    double relative_rmse = 0;     ///< ‖image − reference‖ / ‖reference‖ over all linear colours
    double delta_e_mean = 0, delta_e_max = 0; ///< CIEDE2000 of what a screen shows
    std::optional<double> psnr;               ///< dB, of what a screen shows; nothing where that is the same
    double energy_lost = 0; ///< 1 − sum of the image / sum of the reference: what cuts take away
};

/// @param hits of the image's own configuration
/// @param map if given, set to each pixel's CIEDE2000
[[nodiscard]] ImageError image_error(const Image& image, const std::vector<FirstHit>& hits,
                                     const Reference& reference, Map* map = nullptr);

} // namespace rayscope
