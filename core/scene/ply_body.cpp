#include "core/scene/ply_body.hpp"

#include "core/math/scalar.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace rayscope {
namespace {

bool ends_a_word(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

} // namespace

double PlyDecimals::next(PlyType type) {
    std::size_t begin = 0;
    for (; begin < rest_.size() && ends_a_word(rest_[begin]); ++begin)
        if (rest_[begin] == '\n') ++line_;
    rest_.remove_prefix(begin);
    if (rest_.empty()) fail("expected a number, found the end of the file");
    const char *first = rest_.data(), *const last = rest_.data() + rest_.size();
    if (*first == '+' && last - first > 1 && first[1] != '-') ++first; // which std::from_chars does not take
    double x = 0;
    const auto [end, error] = std::from_chars(first, last, x);
    if (error == std::errc::invalid_argument || (end != last && !ends_a_word(*end))) {
        const auto* const blank = std::find_if(first, last, ends_a_word);
        fail("expected a number, found " + in_quotes({rest_.data(), std::size_t(blank - rest_.data())}));
    }
    const std::string_view text(first, std::size_t(end - first));
    if (error == std::errc::result_out_of_range) { // too small for a double is zero enough
        const bool tiny =
            text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
        x = tiny ? 0 : infinity<double>;
    }
    if (type < PlyType::float32 && x != std::trunc(x)) fail("expected an integer, found " + in_quotes(text));
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    return x;
}

void PlyDecimals::fail(const std::string& message) const { throw InputError(file_, {line_, 0}, message); }

void PlyBytes::fail(const std::string& message) const {
    throw InputError(file_, {}, fmt::format("at byte {} (from 0): {}", size_ - rest_.size(), message));
}

template <typename Number> double PlyBytes::number() {
    if (rest_.size() < sizeof(Number)) fail("expected more numbers, found the end of the file");
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
    rest_.remove_prefix(bytes.size());
    static_assert(std::endian::native == std::endian::little);
    if (big_endian_) std::reverse(bytes.begin(), bytes.end());
    return double(std::bit_cast<Number>(bytes));
}

double PlyBytes::next(PlyType type) {
    switch (type) {
    case PlyType::int8: return number<std::int8_t>();
    case PlyType::uint8: return number<std::uint8_t>();
    case PlyType::int16: return number<std::int16_t>();
    case PlyType::uint16: return number<std::uint16_t>();
    case PlyType::int32: return number<std::int32_t>();
    case PlyType::uint32: return number<std::uint32_t>();
    case PlyType::float32: return number<float>();
    case PlyType::float64: break;
    }
    return number<double>();
}

} // namespace rayscope
