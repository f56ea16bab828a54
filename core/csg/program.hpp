#pragma once
// A compound as a postfix program over a stack of inside lists.

#include "core/csg/sweep.hpp"
#include "core/math/box.hpp"

#include <span>

namespace rayscope {

/// A node of the author's tree. Children come before their parent; the last node is the root.
struct CompoundNode {
    Operation operation = Operation::leaf;
    std::uint32_t left = 0, right = 0; ///< nodes; complement uses left only
    std::uint32_t solid = 0;           ///< leaves: which solid of the world
};

/// One step: push a leaf's inside list, combine what lies on top, or leave out what can't matter.
struct Instruction {
    enum class Kind : std::uint8_t { leaf, guard, extent, combine, complement };
    Kind kind = Kind::leaf;
    Operation operation = Operation::leaf; ///< combine: which
    std::uint32_t operand =
        0; ///< leaf: its solid; guard: where to go on if the top list is empty; extent: which
};

using Program = std::vector<Instruction>;

/// A box around all that a part of a program can enter. A line that misses it has an empty list there.
struct PartExtent {
    Box<double> box;
    std::uint32_t end; ///< the step behind the part
};

/// What is known of a node's list before any ray.
struct NodeExtent {
    Box<double> box; ///< holds it; may be unbounded
    double cost = 1; ///< leaves: of one test, in tests of a box
};

struct CompiledProgram {
    Program program;
    std::vector<PartExtent> extents;
};

/// The tree as a program in which chains of one operation are balanced: D − A − B − C becomes D − (A ∪ (B ∪ C)),
/// and a union of n operands log n deep. Nodes combine exactly, so no such regrouping changes a result, and a chain
/// of 10⁵ nodes costs n log n instead of n². Where the left operand of ∩ or − is empty the right one is not looked at.
/// Iterative: a deep tree needs no deep call stack.
[[nodiscard]] Program compile(std::span<const CompoundNode> nodes);

/// The same with an extent around each part that it pays for: a line that meets what surrounds the part misses its box with
/// a chance of 1 − the ratio of the surfaces, and spares what the part costs; the box itself is tested always.
/// @param extents of each node
/// @param within  the compound's own box, which a ray is known to meet
[[nodiscard]] CompiledProgram compile(std::span<const CompoundNode> nodes,
                                      std::span<const NodeExtent> extents, const Box<double>& within);

/// Looks into every part of a program.
inline constexpr auto no_part_missed = [](std::uint32_t) { return false; };

/// Runs a program; its result is the top list of the stack, which is cleared before.
/// @param push_leaf called as push_leaf(solid): appends that solid's inside list to the open top list
/// @param misses    called as misses(extent): whether the ray's line misses it
template <Scalar T, typename PushLeaf, typename Misses = decltype((no_part_missed))>
void run(std::span<const Instruction> program, SpanStack<T>& stack, const PushLeaf& push_leaf,
         std::span<const PartExtent> extents = {}, Misses&& misses = no_part_missed) {
    stack.clear();
    for (std::size_t i = 0; i < program.size(); ++i) {
        const Instruction& step = program[i];
        switch (step.kind) {
        case Instruction::Kind::leaf:
            stack.push();
            push_leaf(step.operand);
            break;
        case Instruction::Kind::guard:
            if (stack.top_size() == 0) i = step.operand - 1;
            break;
        case Instruction::Kind::extent:
            if (misses(step.operand)) {
                stack.push();
                i = extents[step.operand].end - 1;
            }
            break;
        case Instruction::Kind::combine: stack.combine(step.operation); break;
        case Instruction::Kind::complement: stack.complement(); break;
        }
    }
}

} // namespace rayscope
