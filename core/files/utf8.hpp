#pragma once
// The little of UTF-8 that places in a file need.

#include <cstddef>
#include <string_view>

namespace rayscope {

/// Some editors put it in front of a file; it belongs to no line.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Bytes of the first character of `text`, or 0 if no valid one begins there (RFC 3629: no overlong forms, no
/// surrogates, nothing beyond U+10FFFF).
[[nodiscard]] constexpr std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return continues(1) ? 2 : 0;
    if (first >= 0xE0 && first < 0xF0) {
        const bool overlong = first == 0xE0 && byte(1) < 0xA0, surrogate = first == 0xED && byte(1) >= 0xA0;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first < 0xF5) {
        const bool overlong = first == 0xF0 && byte(1) < 0x90, beyond = first == 0xF4 && byte(1) >= 0x90;
        return continues(1) && continues(2) && continues(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

/// The character that a valid `text` of one character stands for.
[[nodiscard]] constexpr char32_t utf8_code_point(std::string_view character) {
    const auto first = static_cast<unsigned char>(character.front());
    if (first < 0x80) return first;
    // The first byte says the length with as many ones, and a zero.
    char32_t code = first & (0x7FU >> character.size());
    for (const char c : character.substr(1)) code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
    return code;
}

/// True for characters that a terminal obeys instead of showing them: control characters, and those that turn the
/// direction of writing.
[[nodiscard]] constexpr bool steers_terminal(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x202A && c <= 0x202E) ||
           (c >= 0x2066 && c <= 0x2069);
}

/// True for the bytes that a column does not count: those that continue a character.
[[nodiscard]] constexpr bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

} // namespace rayscope
