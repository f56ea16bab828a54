#include "core/walk/tokens.hpp"

#include "core/files/utf8.hpp"
#include "core/scene/wording.hpp"
#include "core/walk/expression.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <numbers>

namespace rayscope {
namespace {

constexpr std::size_t longest = 4000; // bytes of an expression

// Longer spellings first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 25> symbols{{
    {"&&", "&&"}, {"||", "||"}, {"==", "=="}, {"!=", "!="}, {"<=", "<="}, {">=", ">="}, {"≤", "<="},
    {"≥", ">="},  {"≠", "!="},  {"∧", "&&"},  {"∨", "||"},  {"¬", "!"},   {"−", "-"},   {"×", "*"},
    {"·", "*"},   {"÷", "/"},   {"=", "=="},  {"<", "<"},   {">", ">"},   {"!", "!"},   {"+", "+"},
    {"-", "-"},   {"*", "*"},   {"/", "/"},   {"(", "("},
}};

bool starts_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_word(char c) { return starts_word(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

class ExpressionTokens {
public:
    explicit ExpressionTokens(std::string_view text) : text_(text) {}

    std::vector<ExpressionToken> all() {
        while (true) {
            while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
            tokens_.push_back({});
            tokens_.back().column = column();
            if (at_ == text_.size()) return std::move(tokens_);
            read(tokens_.back());
        }
    }

private:
    [[nodiscard]] std::size_t column() const {
        const auto before = text_.substr(0, at_);
        return 1 + std::size_t(std::ranges::count_if(before, [](char c) { return !continues_character(c); }));
    }

    [[nodiscard]] bool digit(std::size_t at) const {
        return at < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at])) != 0;
    }

    void read(ExpressionToken& token) {
        const char c = text_[at_];
        if (digit(at_) || (c == '.' && digit(at_ + 1)))
            number(token);
        else if (starts_word(c))
            word(token);
        else if (c == '\'' || c == '"')
            quoted(token, c);
        else
            symbol(token);
    }

    void number(ExpressionToken& token) {
        token.kind = ExpressionToken::Kind::number;
        const char* const begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), token.number);
        token.text = std::string(begin, end);
        if (error != std::errc())
            throw WrongExpression(token.column, "the number " + in_quotes(token.text) + " is out of range");
        at_ += token.text.size();
        take_unit(token);
        if (at_ < text_.size() && in_word(text_[at_]))
            throw WrongExpression(column(), "expected an operator after the number " + in_quotes(token.text));
    }

    void take_unit(ExpressionToken& token) {
        std::size_t begin = at_;
        while (begin < text_.size() && text_[begin] == ' ') ++begin;
        for (const std::string_view unit : {"°", "deg", "rad"}) {
            const std::size_t end = begin + unit.size();
            const bool word_goes_on = end < text_.size() && unit != "°" && in_word(text_[end]);
            if (!text_.substr(begin).starts_with(unit) || word_goes_on) continue;
            at_ = end;
            if (unit == "rad") token.number *= 180 / std::numbers::pi;
            return;
        }
    }

    // "shadow-blocked" is a name, "t-2" is not.
    void word(ExpressionToken& token) {
        token.kind = ExpressionToken::Kind::word;
        std::size_t end = at_;
        const auto letters = [&] {
            while (end < text_.size() && in_word(text_[end])) ++end;
        };
        letters();
        while (end + 1 < text_.size() && text_[end] == '.' && starts_word(text_[end + 1])) {
            ++end;
            letters();
        }
        token.text = std::string(text_.substr(at_, end - at_));
        if (end + 1 < text_.size() && text_[end] == '-' && starts_word(text_[end + 1])) {
            const std::size_t plain_end = end++;
            letters();
            std::string whole(text_.substr(at_, end - at_));
            std::ranges::replace(whole, '-', '_');
            if (fields().contains(whole))
                token.text = whole;
            else
                end = plain_end;
        }
        at_ = end;
    }

    void quoted(ExpressionToken& token, char quote) {
        token.kind = ExpressionToken::Kind::text;
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos) throw WrongExpression(token.column, "this quote is never closed");
        token.text = std::string(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
    }

    void symbol(ExpressionToken& token) {
        token.kind = ExpressionToken::Kind::symbol;
        const std::string_view rest = text_.substr(at_);
        for (const auto& [spelling, plain] : symbols)
            if (rest.starts_with(spelling)) {
                token.text = plain;
                at_ += spelling.size();
                return;
            }
        if (rest.starts_with(')')) {
            token.text = ")";
            ++at_;
            return;
        }
        const std::size_t length = std::max<std::size_t>(1, utf8_length(rest));
        const char* hint = rest.front() == '&'   ? "; 'and' is written &&"
                           : rest.front() == '|' ? "; 'or' is written ||"
                                                 : "";
        throw WrongExpression(token.column,
                              in_quotes(rest.substr(0, length)) + " has no meaning here" + hint);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<ExpressionToken> tokens_;
};

} // namespace

std::vector<ExpressionToken> tokens_of(const std::string& text) {
    if (text.size() > longest)
        throw WrongExpression(longest + 1, "an expression has at most " + std::to_string(longest) + " bytes");
    return ExpressionTokens(text).all();
}

} // namespace rayscope
