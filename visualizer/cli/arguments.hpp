#pragma once
// Texts of arguments into values.

#include "visualizer/cli/options.hpp"

namespace rayscope::cli {

/// All throw UsageError that names the option and says what was expected.

/// "X,Y": not negative.
[[nodiscard]] std::pair<int, int> parse_pixel(const std::string& text);

/// "ox,oy,oz,dx,dy,dz": six finite numbers, the last three not all 0.
[[nodiscard]] Ray<double> parse_ray(const std::string& text);

/// "WxH": 1 to 32768 each, at most 10⁸ pixels.
[[nodiscard]] Size parse_size(const std::string& text);

/// A whole number within limits.
[[nodiscard]] int parse_count(const std::string& option, const std::string& text, int least, int most);

/// A finite number.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);

/// A finite number above 0.
[[nodiscard]] double parse_positive(const std::string& option, const std::string& text);

/// The name of what a heat map tells.
[[nodiscard]] Heat parse_heat(const std::string& text);

} // namespace rayscope::cli
