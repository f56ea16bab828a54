#include "tests/oracle/line_checks.hpp"

#include "tests/oracle/case_world.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

double epsilon_of(NumbersChoice numbers) {
    return with_numbers(numbers, []<Numbers N>() { return static_cast<double>(epsilon<ScalarOf<N>>); });
}

// Runs check(case, world, spans) on each case, brought to the ε of the numbers.
template <typename Check>
void expect_no_fault(const std::vector<LineCase>& cases, const Check& check, NumbersChoice numbers = {}) {
    constexpr int printed = 5;
    int wrong = 0;
    for (const LineCase& stated : cases) {
        const LineCase exact = at_epsilon(stated, epsilon_of(numbers));
        const CaseWorld world(exact, numbers);
        const FoundSpans found = world.spans();
        const Fault fault = check(exact, world, found);
        if (fault && wrong++ < printed) ADD_FAILURE() << *fault << "\n  in " << describe(exact, found);
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

// Where the traced ray may end: the first bound ahead, and those about t = 0, which rounding may put on
// either side. Sets `required` to false if a miss is right too.
std::vector<const ExactBound*> candidates(const std::vector<MatchedEnd>& ends, bool& required) {
    std::vector<const ExactBound*> bounds;
    for (const auto& [bound, found] : ends) {
        const bool near_start = std::abs(bound->t.nearest) <= bound->tight_tolerance;
        if (bound->t.nearest <= 0 && !near_start) continue;
        bounds.push_back(bound);
        if (!near_start) {
            required = true;
            return bounds;
        }
    }
    required = false;
    return bounds;
}

Fault fault_in_first_hit(const LineCase& exact, const std::vector<MatchedEnd>& ends,
                         const std::optional<FoundEnd>& hit) {
    bool required = false;
    const auto bounds = candidates(ends, required);
    if (!hit) return required ? Fault{"the traced ray misses"} : Fault{};
    for (const ExactBound* bound : bounds)
        if (bound->t.distance(Float128(hit->t)) <= bound->tight_tolerance * allowed_share)
            return fault_in_end(exact, *bound, *hit);
    return text("the traced ray ends at t = ", hex(hit->t));
}

Fault fault_in_error_bound(const ExactBound& exact, const FoundEnd& found) {
    const double error = exact.t.distance(found.value());
    if (error <= found.error_bound) return {};
    return text("at t = ", hex(found.t), " the error is ", hex(error), ", above its bound ",
                hex(found.error_bound));
}

bool is_inside(const std::vector<CaseToken>& program, bool inside_leaf) {
    std::vector<bool> stack;
    for (const CaseToken& token : program) {
        if (token.operation == Operation::leaf) {
            stack.push_back(inside_leaf);
            continue;
        }
        const bool last = stack.back();
        stack.pop_back();
        if (token.operation == Operation::complement) {
            stack.push_back(!last);
        } else {
            const bool first = stack.back();
            stack.back() = holds(token.operation, first, last);
        }
    }
    return stack.back();
}

// The t of all ends, unbounded ones included.
std::vector<double> times(const FoundSpans& spans) {
    std::vector<double> result;
    for (const FoundSpan& span : spans) result.insert(result.end(), {span.enter.t, span.exit.t});
    return result;
}

std::vector<double> times_outside(std::vector<double> inside) {
    inside.insert(inside.begin(), -infinity<double>);
    inside.push_back(infinity<double>);
    std::vector<double> outside;
    for (std::size_t i = 0; i + 1 < inside.size(); i += 2)
        if (inside[i] < inside[i + 1]) outside.insert(outside.end(), {inside[i], inside[i + 1]});
    return outside;
}

Fault fault_in_identity(const LineCase& exact, const FoundSpans& found) {
    LineCase leaf = exact;
    leaf.program.assign(1, {});
    const std::vector<double> alone = times(CaseWorld(leaf).spans());
    const bool inside = is_inside(exact.program, true), outside = is_inside(exact.program, false);
    std::vector<double> expected;
    if (inside && outside)
        expected = {-infinity<double>, infinity<double>};
    else if (inside)
        expected = alone;
    else if (outside)
        expected = times_outside(alone);
    return times(found) == expected ? Fault{} : Fault{"not the same bits as the leaf's"};
}

} // namespace

std::vector<MatchedEnd> comparable_ends(const LineCase& exact, const FoundSpans& found) {
    if (!exact.decidable || exact.in_surface) return {};
    return matched_ends(exact, exact.spans, found);
}

void expect_spans(const std::vector<LineCase>& cases, NumbersChoice numbers) {
    expect_no_fault(
        cases,
        [](const LineCase& exact, const CaseWorld&, const FoundSpans& found) {
            return fault_in_case(exact, found);
        },
        numbers);
}

void expect_surfaces_and_normals(const std::vector<LineCase>& cases, NumbersChoice numbers) {
    expect_no_fault(
        cases,
        [](const LineCase& exact, const CaseWorld&, const FoundSpans& found) {
            for (const auto& [bound, end] : comparable_ends(exact, found))
                if (auto fault = fault_in_end(exact, *bound, *end)) return fault;
            return Fault{};
        },
        numbers);
}

void expect_bounds_of_ends(const std::vector<LineCase>& cases, NumbersChoice numbers) {
    expect_no_fault(
        cases,
        [](const LineCase& exact, const CaseWorld&, const FoundSpans& found) {
            for (const auto& [bound, end] : comparable_ends(exact, found))
                if (auto fault = fault_in_error_bound(*bound, *end)) return fault;
            return Fault{};
        },
        numbers);
}

void expect_first_hits(const std::vector<LineCase>& cases) {
    expect_no_fault(cases, [](const LineCase& exact, const CaseWorld& world, const FoundSpans& found) {
        const auto hit = world.first_hit();
        if (hit && std::isnan(hit->t)) return Fault{"the traced ray ends at NaN"};
        if (!exact.decidable || exact.in_surface) return Fault{};
        return fault_in_first_hit(exact, comparable_ends(exact, found), hit);
    });
}

void expect_error_bounds(const std::vector<LineCase>& cases) {
    expect_bounds_of_ends(cases, {});
    expect_no_fault(cases, [](const LineCase& exact, const CaseWorld& world, const FoundSpans& found) {
        const auto hit = world.first_hit();
        for (const auto& [bound, end] : comparable_ends(exact, found))
            if (hit && hit->t == end->t)
                if (auto fault = fault_in_error_bound(*bound, *hit)) return fault;
        return Fault{};
    });
}

void expect_identities(const std::vector<LineCase>& cases) {
    expect_no_fault(cases, [](const LineCase& exact, const CaseWorld&, const FoundSpans& found) {
        return exact.leaves.size() == 1 ? fault_in_identity(exact, found) : Fault{};
    });
}

Accuracy accuracy_of(const std::vector<LineCase>& cases) {
    Accuracy accuracy;
    for (const LineCase& exact : cases) {
        const FoundSpans found = CaseWorld(exact).spans();
        for (const auto& [bound, end] : comparable_ends(exact, found))
            accuracy.add(*bound, *end, exact.epsilon);
    }
    return accuracy;
}

} // namespace rayscope::test
