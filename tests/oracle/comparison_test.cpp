// The judges are judged: each fault that they are there for is seen, on made-up answers.

#include "tests/oracle/accuracy.hpp"
#include "tests/oracle/comparison.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tolerance = 64e-15; // so that 4e-15 are allowed

ExactBound bound_at(double t) {
    ExactBound bound;
    bound.t = {t, 0};
    bound.tolerance = bound.tight_tolerance = tolerance;
    bound.tight_condition = 10;
    bound.normal_tolerance = 1e-14;
    bound.surfaces.push_back({0, "side", false, Vec3d{0, 0, 1}});
    return bound;
}

// Spans [1, 2] and [3, 4].
LineCase two_spans() {
    LineCase exact;
    exact.bounds = {bound_at(1), bound_at(2), bound_at(3), bound_at(4)};
    exact.spans = {{0, 1}, {2, 3}};
    exact.leaves.push_back({Cube<double>{}, Mat4d{1}});
    exact.ray = {{0, 0, 50}, {0, 0, 1}};
    exact.decidable = true;
    exact.tolerance_sum = 4 * tolerance;
    return exact;
}

FoundEnd end_at(double t) { return {t, 1e-15, 0, "side", false, Vec3d{0, 0, 1}}; }
FoundSpan span(double enter, double exit) { return {end_at(enter), end_at(exit)}; }

TEST(Comparison, TheRightAnswerHasNoFault) {
    EXPECT_EQ(fault_in_case(two_spans(), {span(1, 2), span(3, 4)}), std::nullopt);
}

TEST(Comparison, AWrongCountIsSeen) {
    EXPECT_THAT(fault_in_case(two_spans(), {span(1, 2)}).value_or(""),
                HasSubstr("1 spans where there are 2"));
    EXPECT_NE(fault_in_case(two_spans(), {}), std::nullopt);
    EXPECT_NE(fault_in_case(two_spans(), {span(1, 2), span(3, 4), span(5, 6)}), std::nullopt);
}

TEST(Comparison, ANaNIsSeen) {
    for (const bool decidable : {true, false}) {
        LineCase exact = two_spans();
        exact.decidable = decidable;
        EXPECT_THAT(fault_in_case(exact, {span(1, 2), span(nan, 4)}).value_or(""), HasSubstr("NaN"));
        EXPECT_THAT(fault_in_case(exact, {span(1, nan), span(3, 4)}).value_or(""), HasSubstr("NaN"));
        exact.in_surface = true;
        EXPECT_NE(fault_in_case(exact, {span(nan, nan)}), std::nullopt);
    }
}

TEST(Comparison, AnErrorOfFiveUnitsIsSeenAndOneOfThreeIsNot) {
    const double unit = tolerance / 64;
    EXPECT_EQ(fault_in_case(two_spans(), {span(1 + 3 * unit, 2), span(3, 4)}), std::nullopt);
    EXPECT_THAT(fault_in_case(two_spans(), {span(1 + 5 * unit, 2), span(3, 4)}).value_or(""),
                HasSubstr("is off by"));
    EXPECT_NE(fault_in_case(two_spans(), {span(1, 2), span(3, 4 - 5 * unit)}), std::nullopt);
}

TEST(Comparison, WhatTheNearestDoubleLacksCounts) {
    LineCase exact = two_spans();
    exact.bounds[0].t.rest = 5e-17;
    EXPECT_NEAR(exact.bounds[0].t.distance(1), 5e-17, 1e-19);
    exact.bounds[0].tight_tolerance = 64 * 1e-17; // allows 4e-17
    EXPECT_NE(fault_in_case(exact, {span(1, 2), span(3, 4)}), std::nullopt);
}

TEST(Comparison, DisorderIsSeen) {
    LineCase exact = two_spans();
    exact.in_surface = true;
    EXPECT_EQ(fault_in_case(exact, {span(1, 2)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(3, 4), span(1, 2)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(2, 1)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(1, 1)}), std::nullopt);
}

TEST(Comparison, AnUnboundedEndMustBeInfinite) {
    LineCase exact = two_spans();
    exact.spans = {{std::nullopt, 0}, {3, std::nullopt}};
    EXPECT_EQ(fault_in_case(exact, {span(-infinity<double>, 1), span(4, infinity<double>)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(-1e300, 1), span(4, infinity<double>)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(-infinity<double>, 1), span(4, 1e300)}), std::nullopt);
}

TEST(Comparison, AnUndecidableCaseMayLoseASliverButNotMore) {
    LineCase exact = two_spans();
    exact.decidable = false;
    exact.bounds[1].t = {1 + tolerance, 0};
    EXPECT_EQ(fault_in_case(exact, {span(3, 4)}), std::nullopt);
    EXPECT_THAT(fault_in_case(exact, {span(1, 1 + tolerance)}).value_or(""), HasSubstr("differ on a length"));
    EXPECT_NE(fault_in_case(exact, {span(-infinity<double>, 4)}), std::nullopt);
}

double length_of(const std::vector<Piece>& pieces) {
    long double length = 0;
    for (const Piece& piece : pieces) length += piece.to - piece.from;
    return static_cast<double>(length);
}

TEST(Comparison, DifferencesOfSpansAreMeasured) {
    EXPECT_EQ(length_of(symmetric_difference(two_spans(), {span(1, 2), span(3, 4)})), 0);
    EXPECT_EQ(length_of(symmetric_difference(two_spans(), {})), 2);
    EXPECT_EQ(length_of(symmetric_difference(two_spans(), {span(1.5, 3.25)})), 0.5 + 1 + 0.75);
    EXPECT_EQ(length_of(symmetric_difference(two_spans(), {span(0, infinity<double>)})), infinity<double>);
}

// A line in a face of a cube, or beside it by less than rounding, may be inside all along; farther off it may
// not.
TEST(Comparison, ASpanAlongAFaceIsDoubtful) {
    LineCase exact = two_spans();
    exact.bounds.clear();
    exact.spans.clear();
    exact.decidable = false;
    exact.tolerance_sum = 0;
    exact.ray = {{1 + epsilon<double>, 0, -3}, {0, 0, 1}};
    EXPECT_EQ(fault_in_case(exact, {span(2, 4)}), std::nullopt);
    exact.ray.origin.x = 1 + 1e-12;
    EXPECT_NE(fault_in_case(exact, {span(2, 4)}), std::nullopt);
    exact.ray.origin.x = 0.5;
    EXPECT_NE(fault_in_case(exact, {span(2, 4)}), std::nullopt);
}

TEST(Comparison, ACleanAnswerReplacesSlivers) {
    LineCase exact = two_spans();
    exact.decidable = false;
    exact.clean_decidable = true;
    exact.clean_spans = {{0, 3}};
    EXPECT_EQ(fault_in_case(exact, {span(1, 4)}), std::nullopt);
    EXPECT_NE(fault_in_case(exact, {span(1, 2), span(3, 4)}), std::nullopt);
}

// The ray of `cap_case` enters the cylinder through its upper cap at t = 1, `beside` from the rim.
LineCase cap_case(double beside) {
    LineCase exact;
    exact.leaves.push_back({Cylinder<double>{}, Mat4d{1}});
    exact.ray = {{1 - beside, 0, 2}, {0, 0, -1}};
    ExactBound bound = bound_at(1);
    bound.surfaces = {{0, "cap+", false, Vec3d{0, 0, 1}}};
    exact.bounds = {bound};
    return exact;
}

FoundEnd cap_end() { return {1, 1e-15, 0, "cap+", false, Vec3d{0, 0, 1}}; }

Fault fault_in_cap(const FoundEnd& found, double beside = 0.5) {
    const LineCase exact = cap_case(beside);
    return fault_in_end(exact, exact.bounds[0], found);
}

TEST(Comparison, AWrongNormalIsSeen) {
    FoundEnd end = cap_end();
    EXPECT_EQ(fault_in_cap(end), std::nullopt);
    for (const Vec3d& wrong : {Vec3d{0, 0, -1}, Vec3d{2e-14, 0, 1}, Vec3d{nan, 0, 1}}) {
        end.normal = wrong;
        EXPECT_THAT(fault_in_cap(end).value_or(""), HasSubstr("normal"));
    }
}

TEST(Comparison, AWrongSurfaceIsSeen) {
    FoundEnd end = cap_end();
    end.face = "cap-";
    EXPECT_THAT(fault_in_cap(end).value_or(""), HasSubstr("does not meet"));
    end = cap_end();
    end.flipped = true;
    EXPECT_NE(fault_in_cap(end), std::nullopt);
    end = cap_end();
    end.leaf = 1;
    EXPECT_NE(fault_in_cap(end), std::nullopt);
}

TEST(Comparison, AtAnEdgeTheNeighbouringFaceIsRightToo) {
    FoundEnd end = cap_end();
    end.face = "side";
    end.normal = {1, 0, 0};
    EXPECT_NE(fault_in_cap(end), std::nullopt);
    EXPECT_EQ(fault_in_cap(end, epsilon<double>), std::nullopt);
    end.normal = {0, 0, 1};
    EXPECT_NE(fault_in_cap(end, epsilon<double>), std::nullopt);
}

TEST(Comparison, AnApexHasNoNormalToCompare) {
    LineCase exact = cap_case(0.5);
    exact.bounds[0].surfaces[0].normal.reset();
    FoundEnd end = cap_end();
    end.normal = {1, 0, 0};
    EXPECT_EQ(fault_in_end(exact, exact.bounds[0], end), std::nullopt);
}

TEST(Accuracy, ErrorsAndBoundsAreInUnitsOfTheCondition) {
    Accuracy accuracy;
    EXPECT_TRUE(accuracy.empty());
    const double unit = epsilon<double> * 10;
    for (const double times : {1.0, 2.0, 9.0}) {
        FoundEnd end = end_at(1 + 3 * unit);
        end.error_bound = times * unit;
        accuracy.add(bound_at(1), end, epsilon<double>);
    }
    EXPECT_NEAR(accuracy.worst_error(), 3, 1e-9);
    EXPECT_NEAR(accuracy.bound_at(0.5), 2, 1e-9);
    EXPECT_NEAR(accuracy.bound_at(1), 9, 1e-9);
    EXPECT_THAT(accuracy.summary(), HasSubstr("ends 3"));
}

TEST(Accuracy, BoundsWithoutAConditionHaveNoUnit) {
    Accuracy accuracy;
    ExactBound tangent = bound_at(1);
    tangent.tight_condition = infinity<double>;
    accuracy.add(tangent, end_at(1), epsilon<double>);
    EXPECT_TRUE(accuracy.empty());
}

} // namespace
} // namespace rayscope::test
