#include "core/csg/expression.hpp"

#include "core/files/utf8.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace rayscope {
namespace {

enum class Symbol : std::uint8_t { name, unite, intersect, subtract, negate, open, close, end, stranger };

struct Token {
    Symbol symbol = Symbol::end;
    std::string_view text;
    std::size_t offset = 0;
};

constexpr std::array<std::pair<std::string_view, Symbol>, 10> spellings{{
    {"|", Symbol::unite},
    {"∪", Symbol::unite},
    {"&", Symbol::intersect},
    {"∩", Symbol::intersect},
    {"-", Symbol::subtract},
    {"−", Symbol::subtract},
    {"!", Symbol::negate},
    {"¬", Symbol::negate},
    {"(", Symbol::open},
    {")", Symbol::close},
}};

bool begins_name(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool continues_name(char c) { return begins_name(c) || (c >= '0' && c <= '9'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The first character with the bytes that continue it in UTF-8.
std::size_t character_length(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) ++length;
    return length;
}

Token token_at(std::string_view text, std::size_t offset) {
    while (offset < text.size() && is_blank(text[offset])) ++offset;
    const std::string_view rest = text.substr(offset);
    if (rest.empty()) return {Symbol::end, rest, offset};
    if (begins_name(rest.front())) {
        std::size_t length = 1;
        while (length < rest.size() && continues_name(rest[length])) ++length;
        return {Symbol::name, rest.substr(0, length), offset};
    }
    for (const auto& [spelling, symbol] : spellings)
        if (rest.starts_with(spelling)) return {symbol, rest.substr(0, spelling.size()), offset};
    return {Symbol::stranger, rest.substr(0, character_length(rest)), offset};
}

std::string shown(const Token& token) {
    if (token.symbol == Symbol::end) return "the end";
    if (token.symbol == Symbol::stranger) {
        if (utf8_length(token.text) != token.text.size()) return "bytes that are not UTF-8";
        // Shown as it is, it would garble the line that reports it.
        const char32_t c = utf8_code_point(token.text);
        if (steers_terminal(c)) return fmt::format("U+{:04X}", std::uint32_t(c));
    }
    return "'" + std::string(token.text) + "'";
}

int precedence(Symbol symbol) {
    switch (symbol) {
    case Symbol::unite: return 1;
    case Symbol::intersect:
    case Symbol::subtract: return 2;
    case Symbol::negate: return 3;
    default: return 0; // an open parenthesis yields to nothing
    }
}

Operation operation(Symbol symbol) {
    switch (symbol) {
    case Symbol::unite: return Operation::set_union;
    case Symbol::intersect: return Operation::intersection;
    case Symbol::subtract: return Operation::difference;
    default: return Operation::complement;
    }
}

// Dijkstra's shunting yard: operators wait on a stack of their own until one that binds no tighter arrives.
class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    std::vector<ExpressionNode> parse() {
        Token token = next();
        if (token.symbol == Symbol::end) throw ExpressionError(0, "the expression is empty: expected a name");
        for (;; token = next()) {
            token = read_operand(token);
            while (token.symbol == Symbol::close) token = close(token);
            if (token.symbol == Symbol::end) break;
            wait_for_right_operand(token);
        }
        apply_waiting(1);
        if (!waiting_.empty()) throw ExpressionError(waiting_.back().offset, "this '(' is never closed");
        return std::move(nodes_);
    }

private:
    Token next() {
        const Token token = token_at(text_, position_);
        position_ = token.offset + token.text.size();
        return token;
    }

    // From a token that begins an operand to the one after its name.
    Token read_operand(Token token) {
        for (; token.symbol == Symbol::negate || token.symbol == Symbol::open; token = next())
            waiting_.push_back(token);
        if (token.symbol != Symbol::name)
            throw ExpressionError(token.offset, "expected a name, '!' or '(', found " + shown(token));
        operands_.push_back(nodes_.size());
        nodes_.push_back({Operation::leaf, 0, 0, token.text, token.offset});
        return next();
    }

    Token close(const Token& token) {
        apply_waiting(1);
        if (waiting_.empty()) throw ExpressionError(token.offset, "this ')' closes nothing");
        waiting_.pop_back();
        return next();
    }

    void wait_for_right_operand(const Token& token) {
        const int level = precedence(token.symbol);
        if (level == 0 || token.symbol == Symbol::negate)
            throw ExpressionError(token.offset, "expected an operator (|, & or -), found " + shown(token));
        apply_waiting(level);
        waiting_.push_back(token);
    }

    void apply_waiting(int level) {
        while (!waiting_.empty() && precedence(waiting_.back().symbol) >= level) {
            apply(waiting_.back());
            waiting_.pop_back();
        }
    }

    void apply(const Token& token) {
        ExpressionNode node{operation(token.symbol), 0, 0, {}, token.offset};
        if (token.symbol != Symbol::negate) {
            node.right = operands_.back();
            operands_.pop_back();
        }
        node.left = operands_.back();
        operands_.back() = nodes_.size();
        nodes_.push_back(node);
    }

    std::string_view text_;
    std::size_t position_ = 0;
    std::vector<Token> waiting_;        // operators and open parentheses
    std::vector<std::size_t> operands_; // roots of the finished parts
    std::vector<ExpressionNode> nodes_;
};

} // namespace

std::vector<ExpressionNode> parse_expression(std::string_view text) { return Parser(text).parse(); }

} // namespace rayscope
