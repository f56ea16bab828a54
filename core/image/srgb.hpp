#pragma once
// What a screen shows of a linear colour.

#include "core/math/vec.hpp"

#include <array>
#include <cstdint>

namespace rayscope {

/// The sRGB byte of a linear component (IEC 61966-2-1): clamped to [0, 1], NaN shown as 0, rounded to nearest.
[[nodiscard]] std::uint8_t srgb_byte(float linear);

/// The three bytes that write_image puts into a .png.
[[nodiscard]] std::array<std::uint8_t, 3> srgb_bytes(const Colour& linear);

} // namespace rayscope
