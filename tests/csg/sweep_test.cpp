// Inside lists made by hand: numbers stand for t, and an entry of a list is a span.

#include "core/csg/sweep.hpp"
#include "tests/csg/lists.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

constexpr Operation unite = Operation::set_union, intersect = Operation::intersection,
                    subtract = Operation::difference;

std::vector<double> result(Operation operation, const std::vector<double>& a, const std::vector<double>& b) {
    return times(combined(operation, list_of(1, a), list_of(2, b)));
}

TEST(Holds, truth_table) {
    for (const bool a : {false, true})
        for (const bool b : {false, true}) {
            EXPECT_EQ(holds(unite, a, b), a || b);
            EXPECT_EQ(holds(intersect, a, b), a && b);
            EXPECT_EQ(holds(subtract, a, b), a && !b);
        }
}

using Times = std::vector<double>;

TEST(Sweep, two_spans_in_every_position) {
    const Times a{2, 6};
    struct Case {
        Times b, united, intersected, subtracted;
    };
    const std::vector<Case> cases{
        {{7, 9}, {2, 6, 7, 9}, {}, {2, 6}},     // after
        {{0, 1}, {0, 1, 2, 6}, {}, {2, 6}},     // before
        {{4, 9}, {2, 9}, {4, 6}, {2, 4}},       // overlaps the end
        {{0, 4}, {0, 6}, {2, 4}, {4, 6}},       // overlaps the start
        {{3, 5}, {2, 6}, {3, 5}, {2, 3, 5, 6}}, // inside
        {{0, 9}, {0, 9}, {2, 6}, {}},           // around
        {{2, 6}, {2, 6}, {2, 6}, {}},           // the same
        {{6, 9}, {2, 9}, {}, {2, 6}},           // touches the end
        {{0, 2}, {0, 6}, {}, {2, 6}},           // touches the start
        {{2, 4}, {2, 6}, {2, 4}, {4, 6}},       // flush at the start
        {{4, 6}, {2, 6}, {4, 6}, {2, 4}},       // flush at the end
        {{2, 9}, {2, 9}, {2, 6}, {}},           // flush and longer
        {{0, 6}, {0, 6}, {2, 6}, {}},           //
        {{}, {2, 6}, {}, {2, 6}},               // nothing
        {{-inf, inf}, {-inf, inf}, {2, 6}, {}}, // everything
        {{-inf, 4}, {-inf, 6}, {2, 4}, {4, 6}}, // half spaces
        {{4, inf}, {2, inf}, {4, 6}, {2, 4}},   //
        {{2, inf}, {2, inf}, {2, 6}, {}},       //
        {{-inf, 2}, {-inf, 6}, {}, {2, 6}},     //
        {{0, 3, 5, 9}, {0, 9}, {2, 3, 5, 6}, {3, 5}},
        {{0, 2, 6, 9}, {0, 9}, {}, {2, 6}},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::PrintToString(c.b));
        EXPECT_EQ(result(unite, a, c.b), c.united);
        EXPECT_EQ(result(unite, c.b, a), c.united);
        EXPECT_EQ(result(intersect, a, c.b), c.intersected);
        EXPECT_EQ(result(intersect, c.b, a), c.intersected);
        EXPECT_EQ(result(subtract, a, c.b), c.subtracted);
    }
    EXPECT_EQ(result(subtract, {}, a), Times{});
    EXPECT_EQ(result(subtract, {-inf, inf}, a), (Times{-inf, 2, 6, inf}));
    EXPECT_EQ(result(unite, {}, {}), Times{});
}

TEST(Sweep, the_complement_turns_every_end_and_is_its_own_inverse) {
    const auto complement_times = [](const Times& t) { return times(complemented(list_of(1, t))); };
    EXPECT_EQ(complement_times({}), (Times{-inf, inf}));
    EXPECT_EQ(complement_times({-inf, inf}), Times{});
    EXPECT_EQ(complement_times({1, 2}), (Times{-inf, 1, 2, inf}));
    EXPECT_EQ(complement_times({-inf, 2}), (Times{2, inf}));
    EXPECT_EQ(complement_times({1, inf}), (Times{-inf, 1}));
    EXPECT_EQ(complement_times({-inf, 1, 2, 3, 4, inf}), (Times{1, 2, 3, 4}));
    for (const Times& t : {Times{}, Times{1, 2}, Times{-inf, 2, 5, inf}, Times{1, 2, 3, inf}})
        EXPECT_EQ(complemented(complemented(list_of(1, t))), list_of(1, t));
    const List outside = complemented(list_of(1, {1, 2}));
    EXPECT_TRUE(outside[1].surface.flipped && !outside[1].entering);
    EXPECT_TRUE(outside[2].surface.flipped && outside[2].entering);
}

TEST(Sweep, a_set_and_itself_or_its_complement) {
    for (const Times& t : {Times{1, 2}, Times{1, 2, 3, 4}, Times{-inf, 2}, Times{}, Times{-inf, inf}}) {
        const List a = list_of(1, t);
        EXPECT_TRUE(combined(subtract, a, a).empty());
        EXPECT_TRUE(combined(intersect, a, complemented(a)).empty());
        EXPECT_EQ(times(combined(unite, a, complemented(a))), (Times{-inf, inf}));
        EXPECT_EQ(combined(unite, a, a), a);
        EXPECT_EQ(combined(intersect, a, a), a);
    }
}

TEST(Sweep, a_coincident_face_belongs_to_the_left_operand) {
    const List a = list_of(7, {2, 6}), b = list_of(3, {2, 6}), longer = list_of(3, {2, 9});
    for (const auto operation : {unite, intersect})
        for (const Crossing<double>& c : combined(operation, a, b)) EXPECT_EQ(c.surface.solid, 7U);
    EXPECT_EQ(combined(unite, a, longer)[0].surface.solid, 7U);
    EXPECT_EQ(combined(unite, a, longer)[1].surface.solid, 3U);
    EXPECT_EQ(combined(intersect, longer, a)[0].surface.solid, 3U);
    EXPECT_EQ(combined(intersect, longer, a)[1].surface.solid, 7U);
    // Where one ends and the subtracted one begins, the end is the left one's own and is not flipped.
    const List cut = combined(subtract, a, list_of(3, {6, 9}));
    EXPECT_EQ(cut[1].surface.solid, 7U);
    EXPECT_FALSE(cut[1].surface.flipped);
}

TEST(Sweep, only_what_the_subtracted_part_contributes_is_flipped) {
    const List cut = combined(subtract, list_of(1, {0, 9}), list_of(2, {3, 5}));
    ASSERT_EQ(times(cut), (Times{0, 3, 5, 9}));
    for (std::size_t i = 0; i < 4; ++i) {
        const bool inner = i == 1 || i == 2;
        EXPECT_EQ(cut[i].surface.solid, inner ? 2U : 1U);
        EXPECT_EQ(cut[i].surface.flipped, inner);
        EXPECT_EQ(cut[i].entering, i % 2 == 0);
    }
    // Subtracted from something that is subtracted, a wall is turned back.
    const List twice = combined(subtract, list_of(3, {-1, 99}), cut);
    ASSERT_EQ(times(twice), (Times{-1, 0, 3, 5, 9, 99}));
    EXPECT_TRUE(twice[1].surface.flipped);
    EXPECT_FALSE(twice[2].surface.flipped);
    for (const auto operation : {unite, intersect})
        for (const Crossing<double>& c : combined(operation, list_of(1, {0, 9}), list_of(2, {3, 15})))
            EXPECT_FALSE(c.surface.flipped);
}

TEST(Sweep, lists_lower_on_the_stack_stay_as_they_are) {
    const List below = list_of(9, {1, 2, 3, 4});
    for (const Operation operation : {unite, intersect, subtract})
        for (const Times& b : {Times{}, Times{5, 7}, Times{2, 3}, Times{6, 9}})
            for (const Times& a : {Times{}, Times{2, 6}}) {
                SpanStack<double> stack;
                for (const List& list : {below, list_of(1, a), list_of(2, b)}) push(stack, list);
                stack.combine(operation);
                EXPECT_EQ(top(stack), combined(operation, list_of(1, a), list_of(2, b)));
                stack.complement();
                stack.combine(intersect);
                EXPECT_EQ(top(stack),
                          combined(intersect, below,
                                   complemented(combined(operation, list_of(1, a), list_of(2, b)))));
            }
}

} // namespace
} // namespace rayscope::test
