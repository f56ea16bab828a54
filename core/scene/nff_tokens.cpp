#include "core/scene/nff_tokens.hpp"

#include "core/files/utf8.hpp"
#include "core/scene/decimal_number.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace rayscope {
namespace {

// Products of a few numbers must stay within the range of a double.
constexpr double largest_value = 1e150;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string shown(const NffToken& token) {
    return token.text.empty() ? "the end of the file" : in_quotes(token.text);
}

} // namespace

NffTokens::NffTokens(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3); // the mark of UTF-8, by some editors
    advance();
}

NffToken NffTokens::take() {
    const NffToken token = next_;
    advance();
    return token;
}

void NffTokens::advance() {
    std::size_t i = 0;
    for (bool in_comment = false; i < rest_.size(); ++i) {
        const char c = rest_[i];
        const bool is_lone_return = c == '\r' && !rest_.substr(i).starts_with("\r\n");
        if (c == '\n' || is_lone_return) {
            here_ = {here_.line + 1, 1};
            in_comment = false;
            continue;
        }
        in_comment = in_comment || c == '#';
        if (!in_comment && !is_space(c)) break;
        here_.column += continues_character(c) ? 0 : 1;
    }
    rest_.remove_prefix(i);
    std::size_t length = 0;
    next_.place = here_;
    for (; length < rest_.size() && !is_space(rest_[length]) && rest_[length] != '#'; ++length)
        here_.column += continues_character(rest_[length]) ? 0 : 1;
    next_.text = rest_.substr(0, length);
    rest_.remove_prefix(length);
}

bool NffTokens::number_follows() const {
    if (at_end()) return false;
    const char c = next_.text.front();
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

double NffTokens::number(std::string_view what) {
    const auto x = decimal_number(next_.text);
    if (!x || !(std::abs(*x) <= largest_value))
        fail(next_,
             fmt::format("expected {}, a number of at most 1e150 in size, found {}", what, shown(next_)));
    advance();
    return *x;
}

int NffTokens::integer(std::string_view what, int min, int max) {
    const std::string_view text = without_plus(next_.text);
    int x = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size() || x < min || x > max)
        fail(next_,
             fmt::format("expected {}, an integer from {} to {}, found {}", what, min, max, shown(next_)));
    advance();
    return x;
}

Vec3d NffTokens::vector(std::string_view what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
}

void NffTokens::fail(const NffToken& token, const std::string& message) const {
    throw InputError(file_, token.place, message);
}

} // namespace rayscope
