#include "core/scene/decimal_number.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>

namespace rayscope {
namespace {

// std::from_chars does not tell which way it is out of range. The power of ten of the first digit that is not 0 does.
bool is_below_one(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789"), point = digits.find('.');
    auto power = std::ptrdiff_t(std::min(point, digits.size())) - std::ptrdiff_t(first);
    if (e == std::string_view::npos) return power <= 0;
    std::string_view exponent = text.substr(e + 1);
    const bool is_negative = exponent.starts_with('-');
    if (is_negative || exponent.starts_with('+')) exponent.remove_prefix(1);
    std::ptrdiff_t size = 0;
    if (std::from_chars(exponent.begin(), exponent.end(), size).ec != std::errc{}) return is_negative;
    size = std::min(size, std::ptrdiff_t(1) << 40); // longer than any text
    power += is_negative ? -size : size;
    return power <= 0;
}

} // namespace

std::string_view without_plus(std::string_view text) {
    return text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
}

std::optional<double> decimal_number(std::string_view text) {
    text = without_plus(text);
    double x = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), x);
    if (error == std::errc::invalid_argument || end != text.end()) return std::nullopt;
    if (error != std::errc::result_out_of_range) return x;
    const double size = is_below_one(text) ? 0 : std::numeric_limits<double>::infinity();
    return text.starts_with('-') ? -size : size;
}

} // namespace rayscope
