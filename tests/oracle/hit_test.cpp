// Every generic on every hard line: kind `hit`.

#include "tests/oracle/line_checks.hpp"

#include <cstdio>

namespace rayscope::test {
namespace {

class Hit : public FamilyTest {};

TEST_P(Hit, SpansAreExact) { expect_spans(read_line_cases(path())); }

TEST_P(Hit, NormalsAreExact) { expect_surfaces_and_normals(read_line_cases(path())); }

TEST_P(Hit, FirstHitIsExact) { expect_first_hits(read_line_cases(path())); }

TEST_P(Hit, ErrorBoundHolds) {
    const auto cases = read_line_cases(path());
    expect_error_bounds(cases);
    const Accuracy accuracy = accuracy_of(cases);
    RecordProperty("worst_error", std::to_string(accuracy.worst_error()));
    RecordProperty("median_bound", std::to_string(accuracy.bound_at(0.5)));
    std::printf("%s: %s\n", GetParam().c_str(), accuracy.summary().c_str());
}

INSTANTIATE_TEST_SUITE_P(, Hit, testing::ValuesIn(families("hit")), family_name);

} // namespace
} // namespace rayscope::test
