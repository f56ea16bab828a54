#pragma once
// What a person sees of one wavelength.

#include "core/math/vec.hpp"

namespace rayscope {

/// A spectral colour in linear RGB (sRGB's primaries), not normalized. The 1931 standard observer by the sums of
/// Gaussians of Wyman, Sloan and Shirley (2013), within 1.5 % of the tables; what lies outside of the primaries' triangle
/// is cut to it, since no light is negative.
/// @param wavelength nm
[[nodiscard]] Colour spectral_colour(double wavelength);

} // namespace rayscope
