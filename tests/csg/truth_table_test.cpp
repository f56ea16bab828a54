#include "core/csg/truth_table.hpp"

#include "tests/csg/lists.hpp"
#include "tests/csg/trees.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

struct Gathered {
    OperandEnds<double> ends;
    bool may_hold = false;
    int asked = 0; // operands
};

Gathered gather(const Program& program, const std::vector<Interval<double>>& intervals) {
    Gathered result;
    const auto interval = [&](std::uint32_t solid) {
        ++result.asked;
        return intervals[solid];
    };
    result.may_hold = gather_ends(std::span<const Instruction>(program), std::span<const PartExtent>(),
                                  interval, no_part_missed, result.ends);
    return result;
}

List swept(const Gathered& gathered, const TruthTable& table) {
    SpanStack<double> stack;
    stack.push();
    gathered.ends.sweep(table, stack);
    return top(stack);
}

// Empty, bounded, or without end on one side or both.
Interval<double> random_interval(Random& random, bool whole) {
    if (random.below(5) == 0) return Interval<double>::nothing();
    const auto place = [&] { return whole ? double(random.below(6)) : random.uniform(0, 6); };
    Interval<double> interval{place(), place(), random.below(3), random.below(3)};
    if (interval.exit < interval.enter) std::swap(interval.enter, interval.exit);
    if (random.below(8) == 0) interval.enter = -inf;
    if (random.below(8) == 0) interval.exit = inf;
    return interval.empty() ? Interval<double>::nothing() : interval;
}

TEST(TruthTable, gives_the_programs_list_unless_ends_are_tied) {
    int compared = 0, tied = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(40000)); ++seed) {
        Random random(seed);
        Tree tree;
        std::uint32_t solids = 0;
        grow(random, 1 + random.below(6), solids, tree, Grown::no_complements);
        std::vector<Interval<double>> intervals;
        std::vector<List> leaves;
        const bool whole = random.coin();
        for (std::uint32_t i = 0; i < solids; ++i) {
            const Interval<double> one = intervals.emplace_back(random_interval(random, whole));
            List& list = leaves.emplace_back();
            if (one.empty()) continue;
            list.push_back({one.enter, {i, std::int32_t(one.enter_face), false}, true});
            list.push_back({one.exit, {i, std::int32_t(one.exit_face), false}, false});
        }
        const Program program = compile(tree);
        const TruthTable table = truth_table(program);
        ASSERT_EQ(table.count, solids);
        const Gathered gathered = gather(program, intervals);
        const List expected = run_program(tree, leaves);
        if (!gathered.may_hold) {
            ASSERT_TRUE(expected.empty()) << "seed " << seed;
        }
        if (gathered.ends.tied()) {
            ++tied;
            continue;
        }
        ++compared;
        ASSERT_EQ(swept(gathered, table), expected) << "seed " << seed;
    }
    EXPECT_GT(compared, samples(20000));
    EXPECT_GT(tied, samples(3000));
}

TEST(TruthTable, there_is_none_of_a_complement_or_of_seven_operands) {
    EXPECT_EQ(truth_table(compile(Tree{{Operation::leaf, 0, 0, 0}, {Operation::complement, 0, 0, 0}})).count,
              0U);
    Tree tree{{Operation::leaf, 0, 0, 0}};
    for (std::uint32_t solid = 1; solid <= 6; ++solid) {
        const auto last = std::uint32_t(tree.size() - 1);
        tree.push_back({Operation::leaf, 0, 0, solid});
        tree.push_back({Operation::difference, last, last + 1, 0});
        EXPECT_EQ(truth_table(compile(tree)).count, solid < 6 ? solid + 1 : 0);
    }
}

// (0 − 1) ∩ (2 ∪ 3)
TEST(TruthTable, knows_within_which_operands_all_of_it_lies) {
    const TruthTable table = truth_table(compile(Tree{{Operation::leaf, 0, 0, 0},
                                                      {Operation::leaf, 0, 0, 1},
                                                      {Operation::difference, 0, 1, 0},
                                                      {Operation::leaf, 0, 0, 2},
                                                      {Operation::leaf, 0, 0, 3},
                                                      {Operation::set_union, 3, 4, 0},
                                                      {Operation::intersection, 2, 5, 0}}));
    EXPECT_TRUE(table.lies_within(0));
    for (const std::size_t operand : {1U, 2U, 3U}) EXPECT_FALSE(table.lies_within(operand)) << operand;
    EXPECT_EQ(table.flipped, 0b0010U);
    EXPECT_TRUE(table.holds(0b0101));
    EXPECT_FALSE(table.holds(0b0111));
}

TEST(TruthTable, what_an_empty_part_decides_is_not_looked_at) {
    const Program lens = compile(
        Tree{{Operation::leaf, 0, 0, 0}, {Operation::leaf, 0, 0, 1}, {Operation::intersection, 0, 1, 0}});
    EXPECT_EQ(gather(lens, {Interval<double>::nothing(), {1, 2, 0, 0}}).asked, 1);
    EXPECT_EQ(gather(lens, {{1, 2, 0, 0}, {3, 4, 0, 0}}).asked, 2);
    EXPECT_FALSE(gather(lens, {{1, 2, 0, 0}, {3, 4, 0, 0}}).may_hold);
    EXPECT_TRUE(gather(lens, {{1, 3, 0, 0}, {2, 4, 0, 0}}).may_hold);
}

} // namespace
} // namespace rayscope::test
