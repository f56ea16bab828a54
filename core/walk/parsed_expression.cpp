#include "core/walk/parsed_expression.hpp"

#include "core/scene/wording.hpp"
#include "core/walk/operands.hpp"

#include <algorithm>

namespace rayscope {
namespace {

using Node = Expression::Node;
using Operator = Expression::Operator;
using Index = std::size_t;

constexpr int deepest = 64; // parentheses and signs within each other

bool is_numeric(ValueType type) { return type == ValueType::number || type == ValueType::colour; }

class ExpressionParser {
public:
    ExpressionParser(const std::string& text, const Vocabulary& vocabulary)
        : tokens_(tokens_of(text)), vocabulary_(vocabulary) {}

    std::vector<Node> whole() {
        if (now().kind == ExpressionToken::Kind::end)
            fail("expected a condition, such as 'tir && depth >= 3', or a field, such as 'weight'");
        (void)either();
        if (now().kind != ExpressionToken::Kind::end)
            fail("expected an operator or the end, found " + found());
        return std::move(nodes_);
    }

private:
    // --- tokens

    [[nodiscard]] const ExpressionToken& now() const { return tokens_[at_]; }
    [[nodiscard]] std::string found() const {
        return now().kind == ExpressionToken::Kind::end ? "the end" : in_quotes(now().text);
    }
    [[noreturn]] void fail(const std::string& message) const { fail(now().column, message); }
    [[noreturn]] static void fail(std::size_t column, const std::string& message) {
        throw WrongExpression(column, message);
    }
    bool take(std::string_view symbol, std::string_view word = {}) {
        const bool is_symbol = now().kind == ExpressionToken::Kind::symbol && now().text == symbol;
        const bool is_word = !word.empty() && now().kind == ExpressionToken::Kind::word && now().text == word;
        if (is_symbol || is_word) ++at_;
        return is_symbol || is_word;
    }

    // --- nodes

    Index add(Node node, std::size_t column) {
        node.column = column;
        nodes_.push_back(std::move(node));
        return nodes_.size() - 1;
    }
    Index add(Operator what, ValueType type, Index left, Index right, std::size_t column) {
        Node node;
        node.what = what;
        node.type = type;
        node.left = left;
        node.right = right;
        return add(std::move(node), column);
    }
    void need_condition(Index node) const {
        if (nodes_[node].type == ValueType::condition) return;
        fail(nodes_[node].column, "expected a condition, found " + name_of(nodes_[node].type) +
                                      ": compare it with something, as in 'depth >= 3' or 'object lens'");
    }
    void need_number(Index node) const {
        if (is_numeric(nodes_[node].type)) return;
        const bool vector = nodes_[node].type == ValueType::vector;
        fail(nodes_[node].column, "expected a number, found " + name_of(nodes_[node].type) +
                                      (vector ? ": take its .x, .y or .z" : ""));
    }

    // --- grammar

    Index either() {
        Index left = both();
        for (std::size_t column = now().column; take("||", "or"); column = now().column) {
            need_condition(left);
            const Index right = both();
            need_condition(right);
            left = add(Operator::either, ValueType::condition, left, right, column);
        }
        return left;
    }

    Index both() {
        Index left = inverted();
        for (std::size_t column = now().column; take("&&", "and"); column = now().column) {
            need_condition(left);
            const Index right = inverted();
            need_condition(right);
            left = add(Operator::both, ValueType::condition, left, right, column);
        }
        return left;
    }

    Index inverted() {
        const Nesting nesting(*this);
        const std::size_t column = now().column;
        if (!take("!", "not")) return comparison();
        const Index operand = inverted();
        need_condition(operand);
        return add(Operator::invert, ValueType::condition, operand, 0, column);
    }

    Index comparison() {
        const Index left = sum();
        const std::size_t column = now().column;
        const auto comparing = comparison_operator();
        const bool word = nodes_[left].type == ValueType::word;
        // "object lens", "cell 17": a field and a value beside it are compared.
        const bool beside = !comparing && nodes_[left].what == Operator::field && starts_value(word);
        if (!comparing && !beside) return left;
        const Operator what = comparing.value_or(Operator::equal);
        if (word && what != Operator::equal && what != Operator::unequal)
            fail(column, "a word is compared by == or !=");
        const Index right = word ? word_value(left) : sum();
        check_pair(what, left, right, column);
        if (comparison_operator())
            fail(tokens_[at_ - 1].column, "comparisons can't follow each other: join them by &&");
        return add(what, ValueType::condition, left, right, column);
    }

    std::optional<Operator> comparison_operator() {
        if (take("==")) return Operator::equal;
        if (take("!=")) return Operator::unequal;
        if (take("<=")) return Operator::less_equal;
        if (take(">=")) return Operator::greater_equal;
        if (take("<")) return Operator::less;
        if (take(">")) return Operator::greater;
        return std::nullopt;
    }

    [[nodiscard]] bool starts_value(bool word) const {
        if (now().kind == ExpressionToken::Kind::number) return true;
        if (!word) return false;
        const bool operates =
            now().kind == ExpressionToken::Kind::word && (now().text == "and" || now().text == "or");
        return now().kind == ExpressionToken::Kind::text ||
               (now().kind == ExpressionToken::Kind::word && !operates);
    }

    void check_pair(Operator what, Index left, Index right, std::size_t column) const {
        const ValueType a = nodes_[left].type, b = nodes_[right].type;
        if (what != Operator::equal && what != Operator::unequal) {
            if (a == ValueType::condition) fail(column, "a condition is compared by == or !=");
            need_number(left);
            need_number(right);
        } else if (a != b && !(is_numeric(a) && is_numeric(b))) {
            fail(nodes_[right].column, "expected " + name_of(a) + " to compare with, found " + name_of(b));
        }
    }

    Index sum() {
        Index left = product();
        for (std::size_t column = now().column;; column = now().column) {
            const bool plus = take("+");
            if (!plus && !take("-")) return left;
            left = arithmetic(plus ? Operator::add : Operator::subtract, left, product(), column);
        }
    }

    Index product() {
        Index left = sign();
        for (std::size_t column = now().column;; column = now().column) {
            const bool times = take("*");
            if (!times && !take("/")) return left;
            left = arithmetic(times ? Operator::multiply : Operator::divide, left, sign(), column);
        }
    }

    Index arithmetic(Operator what, Index left, Index right, std::size_t column) {
        need_number(left);
        need_number(right);
        return add(what, ValueType::number, left, right, column);
    }

    Index sign() {
        const Nesting nesting(*this);
        const std::size_t column = now().column;
        if (!take("-")) return primary();
        const Index operand = sign();
        need_number(operand);
        return add(Operator::negate, ValueType::number, operand, 0, column);
    }

    Index primary() {
        const ExpressionToken token = now();
        if (take("(")) {
            const Index inner = either();
            if (!take(")")) fail("expected ')', found " + found());
            return inner;
        }
        if (token.kind == ExpressionToken::Kind::number) {
            ++at_;
            return constant(token.number, token.column);
        }
        if (token.kind == ExpressionToken::Kind::text)
            fail("a name is compared with a field, as in 'object " + std::string("\"") + token.text + "\"'");
        if (token.kind != ExpressionToken::Kind::word) fail("expected a field or a number, found " + found());
        ++at_;
        if (token.text == "abs") return absolute(token.column);
        if (token.text == "inf") return constant(infinity<double>, token.column);
        if (token.text == "true" || token.text == "false") {
            const Index node = constant(token.text == "true" ? 1 : 0, token.column);
            nodes_[node].type = ValueType::condition;
            return node;
        }
        return field(token);
    }

    Index constant(double number, std::size_t column) {
        Node node;
        node.number = number;
        return add(std::move(node), column);
    }

    Index absolute(std::size_t column) {
        if (!take("(")) fail("expected '(' after abs, found " + found());
        const Index operand = either();
        need_number(operand);
        if (!take(")")) fail("expected ')', found " + found());
        return add(Operator::absolute, ValueType::number, operand, 0, column);
    }

    Index field(const ExpressionToken& token) {
        const FieldOperand operand = field_operand(token, vocabulary_);
        Node node;
        node.what = Operator::field;
        node.field = operand.field;
        node.of_kind = operand.of_kind;
        node.type = operand.field->type_of(operand.of_kind);
        const Index whole = add(std::move(node), token.column);
        return operand.axis ? add(Operator::component, ValueType::number, whole, *operand.axis, token.column)
                            : whole;
    }

    Index word_value(Index left) {
        const ExpressionToken token = now();
        if (token.kind == ExpressionToken::Kind::end || token.kind == ExpressionToken::Kind::symbol)
            fail("expected a name, found " + found());
        ++at_;
        check_word(*nodes_[left].field, nodes_[left].of_kind, token, vocabulary_);
        Node node;
        node.type = ValueType::word;
        node.word = token.text;
        return add(std::move(node), token.column);
    }

    struct Nesting {
        explicit Nesting(ExpressionParser& parser) : parser_(parser) {
            if (++parser.depth_ > 2 * deepest)
                parser.fail("more than " + std::to_string(deepest) +
                            " parentheses and signs within each other");
        }
        ~Nesting() { --parser_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        ExpressionParser& parser_;
    };

    std::vector<ExpressionToken> tokens_;
    const Vocabulary& vocabulary_;
    std::vector<Node> nodes_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

std::vector<Node> parsed_expression(const std::string& text, const Vocabulary& vocabulary) {
    return ExpressionParser(text, vocabulary).whole();
}

} // namespace rayscope
