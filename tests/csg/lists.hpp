#pragma once
// Inside lists as values, for tests.

#include "core/csg/program.hpp"
#include "core/csg/sweep.hpp"

#include <ostream>

namespace rayscope {

inline bool operator==(const Crossing<double>& a, const Crossing<double>& b) {
    return a.t == b.t && a.entering == b.entering && (std::isinf(a.t) || a.surface == b.surface);
}
inline void PrintTo(const Crossing<double>& c, std::ostream* out) {
    *out << (c.entering ? "in " : "out ") << c.t << " by " << c.surface.solid << '.' << c.surface.face
         << (c.surface.flipped ? " flipped" : "");
}

namespace test {

inline constexpr double inf = infinity<double>;

using List = std::vector<Crossing<double>>;

/// Spans [t0, t1], [t2, t3] … of one solid.
inline List list_of(std::uint32_t solid, const std::vector<double>& times) {
    List list;
    for (std::size_t i = 0; i < times.size(); ++i)
        list.push_back({times[i], {solid, std::uint16_t(i), false}, i % 2 == 0});
    return list;
}
inline std::vector<double> times(const List& list) {
    std::vector<double> result;
    for (const Crossing<double>& c : list) result.push_back(c.t);
    return result;
}
inline void push(SpanStack<double>& stack, const List& list) {
    stack.push();
    for (const Crossing<double>& c : list) stack.append(c);
}
inline List top(const SpanStack<double>& stack) {
    return {stack.top_begin(), stack.top_begin() + stack.top_size()};
}
inline List combined(Operation operation, const List& a, const List& b) {
    SpanStack<double> stack;
    push(stack, a);
    push(stack, b);
    stack.combine(operation);
    return top(stack);
}
inline List complemented(const List& a) {
    SpanStack<double> stack;
    push(stack, a);
    stack.complement();
    return top(stack);
}

/// The author's tree, node by node.
inline List evaluated(const std::vector<CompoundNode>& nodes, const std::vector<List>& leaves) {
    std::vector<List> lists;
    for (const CompoundNode& node : nodes) {
        if (node.operation == Operation::leaf)
            lists.push_back(leaves[node.solid]);
        else if (node.operation == Operation::complement)
            lists.push_back(complemented(lists[node.left]));
        else
            lists.push_back(combined(node.operation, lists[node.left], lists[node.right]));
    }
    return lists.back();
}
inline List run_program(const std::vector<CompoundNode>& nodes, const std::vector<List>& leaves) {
    SpanStack<double> stack;
    const Program program = compile(nodes);
    run<double>(program, stack, [&](std::uint32_t solid) {
        for (const Crossing<double>& c : leaves[solid]) stack.append(c);
    });
    return top(stack);
}

} // namespace test
} // namespace rayscope
