#include "core/csg/expression.hpp"
#include "core/csg/program.hpp"
#include "tests/csg/lists.hpp"
#include "tests/csg/trees.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// Small whole numbers, so that ends coincide all the time.
List random_list(Random& random, std::uint32_t solid) {
    std::vector<double> times;
    double t = random.below(4);
    if (random.below(6) == 0) times.push_back(-inf);
    for (int n = random.below(5); n > 0; --n) times.push_back(t += 1 + random.below(3));
    if (times.size() % 2 == 1) times.push_back(inf);
    return list_of(solid, times);
}

std::vector<List> random_leaves(Random& random, std::uint32_t count) {
    std::vector<List> leaves;
    for (std::uint32_t i = 0; i < count; ++i) leaves.push_back(random_list(random, i));
    return leaves;
}

bool contains(const List& list, double t) {
    bool inside = false;
    for (const Crossing<double>& c : list)
        if (c.t < t) inside = c.entering;
    return inside;
}

bool contains(const Tree& tree, const std::vector<List>& leaves, double t) {
    std::vector<bool> inside;
    for (const CompoundNode& node : tree) {
        if (node.operation == Operation::leaf)
            inside.push_back(contains(leaves[node.solid], t));
        else if (node.operation == Operation::complement)
            inside.push_back(!inside[node.left]);
        else if (node.operation == Operation::set_union)
            inside.push_back(inside[node.left] || inside[node.right]);
        else if (node.operation == Operation::intersection)
            inside.push_back(inside[node.left] && inside[node.right]);
        else
            inside.push_back(inside[node.left] && !inside[node.right]);
    }
    return inside.back();
}

TEST(Program, gives_the_authors_trees_list_surface_by_surface) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
        Random random(seed);
        Tree tree;
        std::uint32_t solids = 0;
        grow(random, 1 + random.below(9), solids, tree, random.coin() ? Grown::chains : Grown::anything);
        const std::vector<List> leaves = random_leaves(random, solids);
        ASSERT_EQ(run_program(tree, leaves), evaluated(tree, leaves)) << "seed " << seed;
    }
}

TEST(Program, is_inside_where_the_tree_is_point_by_point) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(5000)); ++seed) {
        Random random(seed);
        Tree tree;
        std::uint32_t solids = 0;
        grow(random, 1 + random.below(9), solids, tree, random.coin() ? Grown::chains : Grown::anything);
        const std::vector<List> leaves = random_leaves(random, solids);
        const List list = run_program(tree, leaves);
        for (double t = -0.5; t < 20; t += 1)
            ASSERT_EQ(contains(list, t), contains(tree, leaves, t)) << "t " << t << " seed " << seed;
        for (std::size_t i = 0; i < list.size(); ++i) {
            ASSERT_EQ(list[i].entering, i % 2 == 0) << "seed " << seed;
            if (i > 0) {
                ASSERT_LT(list[i - 1].t, list[i].t) << "seed " << seed;
            }
        }
    }
}

// Any way to put brackets into a chain: the same ends and the same surfaces.
TEST(Program, brackets_in_a_chain_change_nothing) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(5000)); ++seed) {
        Random random(seed);
        const int count = 2 + random.below(7);
        const std::vector<List> leaves = random_leaves(random, std::uint32_t(count));
        for (const Operation operation : {Operation::set_union, Operation::intersection}) {
            std::vector<List> lists = leaves;
            while (lists.size() > 1) {
                const auto at = std::size_t(random.below(int(lists.size()) - 1));
                lists[at] = combined(operation, lists[at], lists[at + 1]);
                lists.erase(lists.begin() + std::ptrdiff_t(at) + 1);
            }
            List chain = leaves[0];
            for (std::size_t i = 1; i < leaves.size(); ++i) chain = combined(operation, chain, leaves[i]);
            ASSERT_EQ(lists[0], chain) << "seed " << seed;
        }
        List taken = leaves[1], one_by_one = leaves[0];
        for (std::size_t i = 2; i < leaves.size(); ++i)
            taken = combined(Operation::set_union, taken, leaves[i]);
        for (std::size_t i = 1; i < leaves.size(); ++i)
            one_by_one = combined(Operation::difference, one_by_one, leaves[i]);
        ASSERT_EQ(combined(Operation::difference, leaves[0], taken), one_by_one) << "seed " << seed;
    }
}

TEST(Program, laws_of_boolean_algebra) {
    const auto unite = [](const List& a, const List& b) { return combined(Operation::set_union, a, b); };
    const auto intersect = [](const List& a, const List& b) {
        return combined(Operation::intersection, a, b);
    };
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(5000)); ++seed) {
        Random random(seed);
        const List a = random_list(random, 0), b = random_list(random, 1), c = random_list(random, 2);
        ASSERT_EQ(complemented(unite(a, b)), intersect(complemented(a), complemented(b))) << seed;
        ASSERT_EQ(complemented(intersect(a, b)), unite(complemented(a), complemented(b))) << seed;
        ASSERT_EQ(combined(Operation::difference, a, b), intersect(a, complemented(b))) << seed;
        ASSERT_EQ(unite(a, intersect(a, b)), a) << seed;
        ASSERT_EQ(intersect(a, unite(a, b)), a) << seed;
        ASSERT_EQ(times(unite(a, b)), times(unite(b, a))) << seed;
        ASSERT_EQ(times(intersect(a, unite(b, c))), times(unite(intersect(a, b), intersect(a, c)))) << seed;
    }
}

Tree chain_of(Operation operation, std::uint32_t count, bool from_the_left) {
    Tree tree;
    for (std::uint32_t i = 0; i < count; ++i)
        tree.push_back({Operation::leaf, 0, 0, from_the_left ? i : count - 1 - i});
    std::uint32_t root = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
        tree.push_back(from_the_left ? CompoundNode{operation, root, i, 0}
                                     : CompoundNode{operation, i, root, 0});
        root = std::uint32_t(tree.size() - 1);
    }
    return tree;
}

// How many lists lie on the stack at most: of a balanced chain, its logarithm.
std::size_t deepest(const Program& program) {
    std::size_t depth = 0, most = 0;
    for (const Instruction& step : program) {
        if (step.kind == Instruction::Kind::leaf) most = std::max(most, ++depth);
        if (step.kind == Instruction::Kind::combine) --depth;
    }
    EXPECT_EQ(depth, 1U);
    return most;
}

// Each of the spans stands alone; the operands are so many that a result that grew one by one would take hours.
TEST(Program, chains_of_a_hundred_thousand_are_balanced_and_give_all_their_spans) {
    constexpr std::uint32_t count = 100000;
    std::vector<List> apart, holes, around;
    for (std::uint32_t i = 0; i < count; ++i) {
        apart.push_back(list_of(i, {2.0 * i, 2.0 * i + 1}));
        holes.push_back(i == 0 ? list_of(0, {-inf, inf}) : apart.back());
        around.push_back(list_of(i, {-1.0 - i, 1.0 + i}));
    }
    for (const bool from_the_left : {true, false}) {
        const Tree all = chain_of(Operation::set_union, count, from_the_left);
        EXPECT_LE(deepest(compile(all)), 18U);
        const List united = run_program(all, apart);
        ASSERT_EQ(united.size(), 2 * count);
        EXPECT_EQ(united.back().t, 2.0 * (count - 1) + 1);
        const Tree shared = chain_of(Operation::intersection, count, from_the_left);
        EXPECT_LE(deepest(compile(shared)), 18U);
        EXPECT_EQ(times(run_program(shared, around)), (std::vector<double>{-1, 1}));
    }
    const Tree drilled = chain_of(Operation::difference, count, true);
    EXPECT_LE(deepest(compile(drilled)), 19U);
    ASSERT_EQ(run_program(drilled, holes).size(), 2 * count);
    // a − (b − (c − …)) can't be regrouped; it still needs no deep call stack.
    const Tree nested = chain_of(Operation::difference, 4, false); // 0 − (1 − (2 − 3)), each within the next
    EXPECT_EQ(times(run_program(nested, around)), (std::vector<double>{}));
    const std::vector<List> inward{list_of(0, {0, 9}), list_of(1, {1, 8}), list_of(2, {2, 7}),
                                   list_of(3, {3, 6})};
    EXPECT_EQ(times(run_program(nested, inward)), (std::vector<double>{0, 1, 2, 3, 6, 7, 8, 9}));
    EXPECT_EQ(deepest(compile(chain_of(Operation::difference, count, false))), count);
}

TEST(Program, a_hundred_thousand_complements_or_parentheses_need_no_call_stack) {
    Tree tree{{Operation::leaf, 0, 0, 0}};
    for (std::uint32_t i = 0; i < 100001; ++i) tree.push_back({Operation::complement, i, 0, 0});
    EXPECT_EQ(times(run_program(tree, {list_of(0, {1, 2})})), (std::vector<double>{-inf, 1, 2, inf}));

    std::string text;
    for (int i = 0; i < 100000; ++i) text += i % 2 == 0 ? "(a-" : "(b|";
    text += "c" + std::string(100000, ')');
    const auto nodes = parse_expression(text);
    Tree parsed;
    for (const ExpressionNode& n : nodes)
        parsed.push_back({n.operation, std::uint32_t(n.left), std::uint32_t(n.right),
                          n.operation == Operation::leaf ? std::uint32_t(n.name[0] - 'a') : 0});
    EXPECT_EQ(parsed.size(), 200001U);
    // a − (b ∪ (a − (b ∪ … c))): outside b, in a, the inner part cancels.
    const List list = run_program(parsed, {list_of(0, {0, 4}), list_of(1, {1, 2}), list_of(2, {9, 10})});
    EXPECT_EQ(contains(list, 1.5), false);
    EXPECT_EQ(contains(list, 9.5), false);
}

std::string written(const Tree& tree) {
    std::string text;
    for (const Instruction& step : compile(tree)) {
        switch (step.kind) {
        case Instruction::Kind::leaf: text += char('0' + step.operand); break;
        case Instruction::Kind::guard: text += '?'; break;
        case Instruction::Kind::extent: ADD_FAILURE() << "nothing was told of boxes"; break;
        case Instruction::Kind::complement: text += '!'; break;
        case Instruction::Kind::combine: text += " |&-"[std::size_t(step.operation)]; break;
        }
    }
    return text;
}

TEST(Program, keeps_the_authors_order_and_guards_the_right_operands) {
    EXPECT_EQ(written(chain_of(Operation::difference, 4, true)), "0?123||-");
    EXPECT_EQ(written(chain_of(Operation::set_union, 4, false)), "01|23||");
    EXPECT_EQ(written(chain_of(Operation::intersection, 4, true)), "0?1&?2?3&&");
}

// Where the left operand is empty, the right one's leaves are not even asked for.
TEST(Program, an_empty_left_operand_ends_early) {
    for (const Operation operation : {Operation::difference, Operation::intersection}) {
        const Program program = compile(chain_of(operation, 5, true));
        SpanStack<double> stack;
        int asked = 0;
        run<double>(program, stack, [&](std::uint32_t) { ++asked; });
        EXPECT_EQ(asked, 1);
        EXPECT_EQ(stack.top_size(), 0U);
    }
}

} // namespace
} // namespace rayscope::test
