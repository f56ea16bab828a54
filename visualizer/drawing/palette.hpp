#pragma once
// The colours of a picture: Okabe and Ito's, which colour-blind people tell apart, on a light ground.

#include "core/rayscope.hpp"

#include <array>

namespace rayscope::drawing {

struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;

    [[nodiscard]] bool operator==(const Rgb&) const = default;
};

inline constexpr Rgb ink{0x22, 0x22, 0x22}, quiet_ink{0x66, 0x66, 0x66}, hair{0xCC, 0xD0, 0xD6};
inline constexpr Rgb paper{0xFF, 0xFF, 0xFF}, panel{0xF6, 0xF7, 0xF9}, sky{0xF1, 0xF4, 0xF8};
inline constexpr Rgb highlight{0xFF, 0xEE, 0x99}, normal_green{0x00, 0x9E, 0x73},
    hit_purple{0xAA, 0x3C, 0x84};
inline constexpr Rgb light_yellow{0xF0, 0xC0, 0x20}, place_blue{0x6A, 0x7F, 0xA8};

/// Lines of a ray: by kind, in the hue of its wavelength if it has one, and grey for a shadow ray that something opaque stops.
[[nodiscard]] Rgb ray_colour(const TracedRay& ray);
/// The same, dark enough for text.
[[nodiscard]] Rgb ray_text_colour(const TracedRay& ray);
[[nodiscard]] const char* kind_name(RayKind kind);

/// Colour of the i-th lane of inside intervals; neighbours differ, and none is a ray's colour.
[[nodiscard]] Rgb lane_colour(std::size_t lane, bool root);

/// share = 0 gives a, 1 gives b.
[[nodiscard]] Rgb mixed(Rgb a, Rgb b, double share);

/// What a screen shows of a linear colour: clamped, sRGB-encoded.
[[nodiscard]] Rgb on_screen(const Colour& linear);

} // namespace rayscope::drawing
