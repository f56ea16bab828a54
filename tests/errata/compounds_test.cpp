// chapters/errata.md, what concerns compounds: the printed form fails, the right one holds.

#include "core/csg/expression.hpp"
#include "core/csg/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <map>
#include <set>

namespace rayscope::test {
namespace {

/// A set of the four parts into which two solids cut space: neither, A only, B only, both. Or, with three, of eight.
template <std::size_t n> using Parts = std::bitset<n>;

template <std::size_t n>
Parts<n> evaluated(const std::vector<ExpressionNode>& nodes,
                   const std::map<std::string_view, Parts<n>>& leaves) {
    std::vector<Parts<n>> values; // children come before their parents: post order
    for (const ExpressionNode& node : nodes) switch (node.operation) {
        case Operation::leaf: values.push_back(leaves.at(node.name)); break;
        case Operation::set_union: values.push_back(values[node.left] | values[node.right]); break;
        case Operation::intersection: values.push_back(values[node.left] & values[node.right]); break;
        case Operation::difference: values.push_back(values[node.left] & ~values[node.right]); break;
        case Operation::complement: values.push_back(~values[node.left]); break;
        }
    return values.back();
}

/// The letters and operators as an in-order walk meets them: without the parentheses.
std::string in_order(const std::vector<ExpressionNode>& nodes, std::size_t at) {
    const ExpressionNode& node = nodes[at];
    if (node.operation == Operation::leaf) return std::string(node.name);
    const char* const sign = node.operation == Operation::set_union      ? "|"
                             : node.operation == Operation::intersection ? "&"
                                                                         : "-";
    return in_order(nodes, node.left) + sign + in_order(nodes, node.right);
}

TEST(Compounds, in_order) {
    const std::map<std::string_view, Parts<8>> leaves{{"A", 0xaa}, {"B", 0xcc}, {"C", 0xf0}};
    const auto nodes = parse_expression("(A|B)&C");
    const std::string walked = in_order(nodes, nodes.size() - 1);
    EXPECT_EQ(walked, "A|B&C");
    EXPECT_NE(evaluated(nodes, leaves), evaluated(parse_expression(walked), leaves));
    // Where every right operand is a leaf, as in the notes' example, the two orders agree: it hides the difference.
    const std::map<std::string_view, Parts<16>> four{
        {"A", 0xaaaa}, {"B", 0xcccc}, {"C", 0xf0f0}, {"D", 0xff00}};
    const auto example = parse_expression("((A&B)-C)-D");
    EXPECT_EQ(evaluated(example, four),
              evaluated(parse_expression(in_order(example, example.size() - 1)), four));
}

TEST(Compounds, sixteen) {
    const Parts<4> a = 0b1010, b = 0b1100; // bit 0: the part in neither
    const auto less = [](const Parts<4>& x, const Parts<4>& y) { return x.to_ulong() < y.to_ulong(); };
    std::set<Parts<4>, decltype(less)> once({a | b, a & b, a & ~b, b & ~a}, less);
    EXPECT_EQ(once.size(), 4U) << "one use of an operator, as printed";

    std::set<Parts<4>, decltype(less)> all({a, b}, less);
    for (std::size_t before = 0; before != all.size();) { // all expressions
        before = all.size();
        const std::vector<Parts<4>> known(all.begin(), all.end());
        for (const Parts<4>& x : known) {
            all.insert(~x);
            for (const Parts<4>& y : known) all.insert({x | y, x & y, x & ~y});
        }
    }
    EXPECT_EQ(all.size(), 16U);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Parts<4>& x) { return !x[0]; }), 8) << "bounded";
}

} // namespace
} // namespace rayscope::test
