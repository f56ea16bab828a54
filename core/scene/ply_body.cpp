#include "core/scene/ply_body.hpp"

#include "core/math/scalar.hpp"
#include "core/scene/decimal_number.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rayscope {
namespace {

bool ends_a_word(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

} // namespace

double PlyDecimals::next(PlyType type) {
    skip_blanks();
    if (rest_.empty()) fail("expected a number, found the end of the file");
    const auto* const blank = std::find_if(rest_.begin(), rest_.end(), ends_a_word);
    const std::string_view word(rest_.begin(), blank);
    const auto x = decimal_number(word);
    if (!x) fail("expected a number, found " + in_quotes(word));
    if (type < PlyType::float32 && *x != std::trunc(*x))
        fail("expected an integer, found " + in_quotes(word));
    rest_.remove_prefix(word.size());
    return *x;
}

void PlyDecimals::end() {
    skip_blanks();
    if (!rest_.empty())
        fail("expected the end of the file: the header counts no more elements; found " +
             in_quotes({rest_.begin(), std::find_if(rest_.begin(), rest_.end(), ends_a_word)}));
}

void PlyDecimals::skip_blanks() {
    const auto* const word = std::find_if_not(rest_.begin(), rest_.end(), ends_a_word);
    line_ += int(std::count(rest_.begin(), word, '\n'));
    rest_.remove_prefix(std::size_t(word - rest_.begin()));
}

void PlyDecimals::fail(const std::string& message) const { throw InputError(file_, {line_, 0}, message); }

void PlyBytes::end() const {
    if (!std::all_of(rest_.begin(), rest_.end(), ends_a_word))
        fail(fmt::format(
            "expected the end of the file: the header counts no more elements; found {} more bytes",
            rest_.size()));
}

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
