#include "visualizer/drawing/palette.hpp"

#include "visualizer/drawing/ray_path.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

constexpr std::array<Rgb, 4> kinds{Rgb{0x18, 0x18, 0x18}, Rgb{0x00, 0x72, 0xB2}, Rgb{0xD5, 0x5E, 0x00},
                                   Rgb{0xE6, 0x9F, 0x00}};
constexpr Rgb blocked_grey{0x90, 0x90, 0x90};
constexpr std::array<Rgb, 6> lanes{Rgb{0x56, 0xB4, 0xE9}, Rgb{0xCC, 0x79, 0xA7}, Rgb{0x00, 0x9E, 0x73},
                                   Rgb{0x8D, 0x6B, 0xB8}, Rgb{0x9A, 0x6A, 0x48}, Rgb{0x7F, 0x95, 0xA8}};

std::uint8_t byte(double value) { return std::uint8_t(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

// As bright as the others: a light ground swallows pure yellow.
Rgb hue_of(double wavelength) {
    constexpr double darker = 0.2;
    const Colour spectral = spectral_colour(wavelength);
    const double most = largest_component(spectral);
    return most > 0 ? mixed(on_screen(spectral / most), ink, darker) : ink;
}

} // namespace

Rgb ray_colour(const TracedRay& ray) {
    const RaySpawned& start = ray.start();
    if (is_blocked(ray)) return blocked_grey;
    if (start.wavelength > 0 && start.kind != RayKind::shadow) return hue_of(start.wavelength);
    return kinds.at(std::size_t(start.kind));
}

Rgb ray_text_colour(const TracedRay& ray) {
    const bool pale = ray.start().kind == RayKind::shadow;
    return mixed(ray_colour(ray), ink, pale ? 0.38 : 0.0);
}

const char* kind_name(RayKind kind) {
    constexpr std::array<const char*, 4> names{"eye", "reflected", "refracted", "shadow"};
    return names.at(std::size_t(kind));
}

Rgb lane_colour(std::size_t lane, bool root) {
    return root ? Rgb{0x33, 0x33, 0x33} : lanes.at(lane % lanes.size());
}

Rgb mixed(Rgb a, Rgb b, double share) {
    const auto mix = [&](std::uint8_t x, std::uint8_t y) { return byte((x + (y - x) * share) / 255); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Rgb on_screen(const Colour& linear) {
    const auto bytes = srgb_bytes(linear);
    return {bytes[0], bytes[1], bytes[2]};
}

} // namespace rayscope::drawing
