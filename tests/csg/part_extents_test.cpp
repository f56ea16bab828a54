// Guards against a box that hides what a line enters, and against boxes that cost more than they save.

#include "tests/csg/lists.hpp"
#include "tests/csg/trees.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace rayscope::test {
namespace {

/// Where a line is in a box: its list, as a cube's kernel would find it, or an extent's answer.
std::optional<std::pair<double, double>> inside(const Box<double>& box, const Ray<double>& line) {
    double enter = -inf, exit = inf;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.low[axis] - line.origin[axis]) / line.direction[axis],
                     b = (box.high[axis] - line.origin[axis]) / line.direction[axis];
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    if (!(enter < exit)) return std::nullopt;
    return std::pair(enter, exit);
}

Box<double> box_of(const CompoundNode& node, const std::vector<NodeExtent>& extents) {
    const auto box = [&](std::uint32_t child) { return extents[child].box; };
    switch (node.operation) {
    case Operation::set_union: return united(box(node.left), box(node.right));
    case Operation::intersection: return intersected(box(node.left), box(node.right));
    case Operation::difference: return box(node.left);
    default: return Box<double>::everything();
    }
}

/// Boxes, and boxes of them.
struct Parts {
    Tree tree;
    std::vector<NodeExtent> extents;
    std::vector<Box<double>> leaves;

    std::uint32_t leaf(const Box<double>& box, double cost) {
        tree.push_back({Operation::leaf, 0, 0, std::uint32_t(leaves.size())});
        extents.push_back({box, cost});
        leaves.push_back(box);
        return std::uint32_t(tree.size() - 1);
    }
    std::uint32_t node(Operation operation, std::uint32_t left, std::uint32_t right) {
        tree.push_back({operation, left, right, 0});
        extents.push_back({box_of(tree.back(), extents), 1});
        return std::uint32_t(tree.size() - 1);
    }
    [[nodiscard]] CompiledProgram compiled() const { return compile(tree, extents, extents.back().box); }
};

Box<double> random_box(Random& random, double spread) {
    Box<double> box;
    const Vec3d centre = random.in_cube(spread);
    box.include(centre - Vec3d{random.decade(-1, 0.5)});
    box.include(centre + Vec3d{random.decade(-1, 0.5)});
    return box;
}

std::uint32_t grow(Random& random, int leaves, Parts& parts) {
    if (leaves == 1) return parts.leaf(random_box(random, 4), random.decade(0, 1.5));
    if (random.below(6) == 0) return parts.node(Operation::complement, grow(random, leaves, parts), 0);
    const int left = random.coin() ? leaves - 1 : 1 + random.below(leaves - 1);
    const std::uint32_t a = grow(random, left, parts);
    const std::uint32_t b = grow(random, leaves - left, parts);
    return parts.node(Operation(1 + random.below(3)), a, b);
}

TEST(PartExtents, leave_out_nothing_that_a_line_enters) {
    std::size_t missed = 0, met = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
        Random random(seed);
        Parts parts;
        grow(random, 1 + random.below(12), parts);
        const Ray<double> line{random.in_cube(6), random.direction()};
        std::vector<List> lists;
        for (std::uint32_t i = 0; i < parts.leaves.size(); ++i) {
            const auto span = inside(parts.leaves[i], line);
            lists.push_back(span ? list_of(i, {span->first, span->second}) : List{});
        }
        const CompiledProgram compiled = parts.compiled();
        SpanStack<double> stack;
        run<double>(
            compiled.program, stack,
            [&](std::uint32_t solid) {
                for (const Crossing<double>& c : lists[solid]) stack.append(c);
            },
            compiled.extents,
            [&](std::uint32_t extent) {
                const bool misses = !inside(compiled.extents[extent].box, line);
                ++(misses ? missed : met);
                return misses;
            });
        ASSERT_EQ(top(stack), evaluated(parts.tree, lists)) << "seed " << seed;
    }
    EXPECT_GT(missed, met / 4) << "hardly anything was left out: nothing is tested here";
}

Box<double> cube_at(double x, double size) {
    return {Vec3d{x - size, -size, -size}, Vec3d{x + size, size, size}};
}

/// Leaves as digits, what an extent holds in brackets.
std::string written(const CompiledProgram& compiled) {
    std::string text;
    for (std::size_t i = 0; i <= compiled.program.size(); ++i) {
        for (const PartExtent& extent : compiled.extents)
            if (extent.end == i) text += ']';
        if (i == compiled.program.size()) break;
        const Instruction& step = compiled.program[i];
        switch (step.kind) {
        case Instruction::Kind::leaf: text += char('0' + step.operand); break;
        case Instruction::Kind::guard: text += '?'; break;
        case Instruction::Kind::extent: text += '['; break;
        case Instruction::Kind::complement: text += '!'; break;
        case Instruction::Kind::combine: text += " |&-"[std::size_t(step.operation)]; break;
        }
    }
    return text;
}

TEST(PartExtents, stand_where_they_save_more_than_they_cost) {
    const auto row = [](double size, double cost) { // four cubes from x = −3 to 3
        Parts parts;
        std::uint32_t all = parts.leaf(cube_at(-3, size), cost);
        for (int i = 1; i < 4; ++i)
            all = parts.node(Operation::set_union, all, parts.leaf(cube_at(2 * i - 3, size), cost));
        return written(parts.compiled());
    };
    EXPECT_EQ(row(0.1, 20), "[[0][1]|][[2][3]|]|") << "dear and far apart: each has its own, and each pair";
    EXPECT_EQ(row(0.1, 3), "[01|][23|]|") << "cheap: a pair, not one alone";
    EXPECT_EQ(row(3, 3), "01|23||") << "who meets one meets all";
}

TEST(PartExtents, are_not_put_around_what_has_no_end_or_is_already_met) {
    const auto cut_from = [](const Box<double>& whole, const Box<double>& part) {
        Parts parts;
        const std::uint32_t first = parts.leaf(whole, 100);
        parts.node(Operation::difference, first, parts.leaf(part, 100));
        return written(parts.compiled());
    };
    EXPECT_EQ(cut_from(Box<double>::everything(), cube_at(0, 1)), "0?[1]-") << "a half space";
    EXPECT_EQ(cut_from(cube_at(0, 1), cube_at(0, 0.999)), "0?1-") << "a bowl";
}

} // namespace
} // namespace rayscope::test
