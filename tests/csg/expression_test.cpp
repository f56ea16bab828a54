#include "core/csg/expression.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rayscope {
namespace {

// The tree with all its parentheses, iteratively: some trees here are a million nodes deep.
std::string bracketed(const std::vector<ExpressionNode>& nodes) {
    std::vector<std::string> texts;
    for (const ExpressionNode& node : nodes) {
        switch (node.operation) {
        case Operation::leaf: texts.emplace_back(node.name); break;
        case Operation::complement: texts.push_back("!" + texts[node.left]); break;
        case Operation::set_union:
            texts.push_back("(" + texts[node.left] + "|" + texts[node.right] + ")");
            break;
        case Operation::intersection:
            texts.push_back("(" + texts[node.left] + "&" + texts[node.right] + ")");
            break;
        case Operation::difference:
            texts.push_back("(" + texts[node.left] + "-" + texts[node.right] + ")");
            break;
        }
    }
    return texts.back();
}

std::string bracketed(std::string_view text) { return bracketed(parse_expression(text)); }

void expect_error(std::string_view text, std::size_t offset, const std::string& message) {
    try {
        (void)parse_expression(text);
        ADD_FAILURE() << "no error in " << text;
    } catch (const ExpressionError& error) {
        EXPECT_EQ(error.offset, offset) << text;
        EXPECT_EQ(error.what(), message) << text;
    }
}

TEST(Expression, PrecedenceTable) {
    EXPECT_EQ(bracketed("a"), "a");
    EXPECT_EQ(bracketed("a|b|c"), "((a|b)|c)");
    EXPECT_EQ(bracketed("a-b-c"), "((a-b)-c)");
    EXPECT_EQ(bracketed("a&b&c"), "((a&b)&c)");
    EXPECT_EQ(bracketed("A-B&C"), "((A-B)&C)");
    EXPECT_EQ(bracketed("A&B-C"), "((A&B)-C)");
    EXPECT_EQ(bracketed("a|b&c"), "(a|(b&c))");
    EXPECT_EQ(bracketed("a|b-c"), "(a|(b-c))");
    EXPECT_EQ(bracketed("a&b|c"), "((a&b)|c)");
    EXPECT_EQ(bracketed("a-b|c-d"), "((a-b)|(c-d))");
    EXPECT_EQ(bracketed("!a&b"), "(!a&b)");
    EXPECT_EQ(bracketed("a&!b"), "(a&!b)");
    EXPECT_EQ(bracketed("a-!!b"), "(a-!!b)");
    EXPECT_EQ(bracketed("!(a|b)&c"), "(!(a|b)&c)");
    EXPECT_EQ(bracketed("a-(b-c)"), "(a-(b-c))");
    EXPECT_EQ(bracketed("(a|b)&(c|d)"), "((a|b)&(c|d))");
    EXPECT_EQ(bracketed("((a))"), "a");
}

TEST(Expression, SpellingsOfTheNotes) {
    EXPECT_EQ(bracketed("(outer - inner) - mouth"), "((outer-inner)-mouth)");
    EXPECT_EQ(bracketed("a ∪ b ∩ ¬c − d"), "(a|((b&!c)-d))");
    EXPECT_EQ(bracketed("\n a\t|\r\n b "), "(a|b)");
    EXPECT_EQ(bracketed("_a1-B_2"), "(_a1-B_2)");
}

TEST(Expression, OffsetsCountBytes) {
    const auto nodes = parse_expression("a ∪ !bc");
    ASSERT_EQ(nodes.size(), 4U);
    EXPECT_EQ(nodes[0].offset, 0U);
    EXPECT_EQ(nodes[1].offset, 7U); // bc
    EXPECT_EQ(nodes[2].offset, 6U); // !
    EXPECT_EQ(nodes[3].offset, 2U); // ∪
}

TEST(Expression, Errors) {
    expect_error("", 0, "the expression is empty: expected a name");
    expect_error("  ", 0, "the expression is empty: expected a name");
    expect_error("a -", 3, "expected a name, '!' or '(', found the end");
    expect_error("a - | b", 4, "expected a name, '!' or '(', found '|'");
    expect_error("- a", 0, "expected a name, '!' or '(', found '-'");
    expect_error("()", 1, "expected a name, '!' or '(', found ')'");
    expect_error("a b", 2, "expected an operator (|, & or -), found 'b'");
    expect_error("a ! b", 2, "expected an operator (|, & or -), found '!'");
    expect_error("a (b)", 2, "expected an operator (|, & or -), found '('");
    expect_error("a + b", 2, "expected an operator (|, & or -), found '+'");
    expect_error("a - é", 4, "expected a name, '!' or '(', found 'é'");
    expect_error("a - 2b", 4, "expected a name, '!' or '(', found '2'");
    expect_error("a | (b - (c)", 4, "this '(' is never closed");
    expect_error("a | b)", 5, "this ')' closes nothing");
    expect_error(")", 0, "expected a name, '!' or '(', found ')'");
    // What a terminal would obey is spelled out.
    const std::string wanted = "expected an operator (|, & or -), found ";
    expect_error("a \x01", 2, wanted + "U+0001");
    expect_error("a \x7F", 2, wanted + "U+007F");
    expect_error("a \u0080", 2, wanted + "U+0080");
    expect_error("a \u009B", 2, wanted + "U+009B");
    expect_error("a \u00A1", 2, wanted + "'\u00A1'");
    expect_error("a \u202A", 2, wanted + "U+202A");
    expect_error("a \u202E", 2, wanted + "U+202E");
    expect_error("a \u2066", 2, wanted + "U+2066");
    expect_error("a \u2069", 2, wanted + "U+2069");
    expect_error("a \u2070", 2, wanted + "'\u2070'");
    expect_error("a \xFF", 2, wanted + "bytes that are not UTF-8");
}

// Recursion would overflow the call stack, and anything quadratic would not end.
TEST(Expression, AMillionOperandsInAChain) {
    std::string text = "a";
    for (int i = 1; i < 1000000; ++i) text += "-a";
    const auto nodes = parse_expression(text);
    ASSERT_EQ(nodes.size(), 1999999U);
    EXPECT_EQ(nodes.back().left, 1999996U);
    EXPECT_EQ(nodes.back().right, 1999997U);
}

TEST(Expression, AMillionParentheses) {
    const std::string open(1000000, '('), close(1000000, ')');
    EXPECT_EQ(parse_expression(open + "a" + close).size(), 1U);
    expect_error(open + "a", 999999, "this '(' is never closed");
}

TEST(Expression, AMillionComplements) {
    std::string text(1000000, '!');
    text += 'a';
    EXPECT_EQ(parse_expression(text).size(), 1000001U);
}

TEST(Expression, AMillionOperandsNestedToTheRight) {
    std::string text;
    for (int i = 0; i < 1000000; ++i) text += "a|(";
    EXPECT_EQ(parse_expression(text + "a" + std::string(1000000, ')')).size(), 2000001U);
}

} // namespace
} // namespace rayscope
