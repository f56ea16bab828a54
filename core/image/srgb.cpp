#include "core/image/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

double decoded(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// thresholds[i]: the least linear value that rounds to byte i + 1.
const std::array<float, 255>& thresholds() {
    static const auto table = [] {
        std::array<float, 255> values;
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(decoded((double(i) + 0.5) / 255));
        return values;
    }();
    return table;
}

} // namespace

std::uint8_t srgb_byte(float linear) {
    // A search in 255 thresholds gives the byte without a power for each of the image's components.
    if (!(linear > 0)) return 0;
    const auto& table = thresholds();
    return std::uint8_t(std::upper_bound(table.begin(), table.end(), linear) - table.begin());
}

std::array<std::uint8_t, 3> srgb_bytes(const Colour& linear) {
    return {srgb_byte(float(linear.x)), srgb_byte(float(linear.y)), srgb_byte(float(linear.z))};
}

} // namespace rayscope
