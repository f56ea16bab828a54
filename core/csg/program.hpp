#pragma once
// A compound as a postfix program over a stack of inside lists.

#include "core/csg/sweep.hpp"

#include <span>

namespace rayscope {

/// A node of the author's tree. Children come before their parent; the last node is the root.
struct CompoundNode {
    Operation operation = Operation::leaf;
    std::uint32_t left = 0, right = 0; ///< nodes; complement uses left only
    std::uint32_t solid = 0;           ///< leaves: which solid of the world
};

/// One step: push a leaf's inside list, or combine what lies on top.
struct Instruction {
    Operation operation = Operation::leaf;
    std::uint32_t solid = 0; ///< leaves
};

using Program = std::vector<Instruction>;

/// The tree as a program in which chains of one operation are balanced: D − A − B − C becomes D − (A ∪ (B ∪ C)),
/// and a union of n operands log n deep. Nodes combine exactly, so no such regrouping changes a result, and a chain
/// of 10⁵ nodes costs n log n instead of n². Iterative: a deep tree needs no deep call stack.
[[nodiscard]] Program compile(std::span<const CompoundNode> nodes);

/// Runs a program; its result is the top list of the stack, which is cleared before.
/// @param push_leaf called as push_leaf(solid): appends that solid's inside list to the open top list
template <Scalar T, typename PushLeaf>
void run(std::span<const Instruction> program, SpanStack<T>& stack, const PushLeaf& push_leaf) {
    stack.clear();
    for (const Instruction& step : program) {
        if (step.operation == Operation::leaf) {
            stack.push();
            push_leaf(step.solid);
        } else if (step.operation == Operation::complement) {
            stack.complement();
        } else {
            stack.combine(step.operation);
        }
    }
}

} // namespace rayscope
