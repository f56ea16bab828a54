// Compounds on hard lines: kind `csg`.

#include "tests/oracle/line_checks.hpp"

#include <cstdio>

namespace rayscope::test {
namespace {

class Csg : public FamilyTest {};

TEST_P(Csg, SpansAreExact) { expect_spans(read_line_cases(path())); }

TEST_P(Csg, SurfacesAndNormalsAreExact) { expect_surfaces_and_normals(read_line_cases(path())); }

TEST_P(Csg, FirstHitIsExact) { expect_first_hits(read_line_cases(path())); }

TEST_P(Csg, ErrorBoundHolds) {
    const auto cases = read_line_cases(path());
    expect_error_bounds(cases);
    const Accuracy accuracy = accuracy_of(cases);
    RecordProperty("worst_error", std::to_string(accuracy.worst_error()));
    RecordProperty("median_bound", std::to_string(accuracy.bound_at(0.5)));
    std::printf("%s: %s\n", GetParam().c_str(), accuracy.summary().c_str());
}

TEST_P(Csg, OneLeafNeedsNoTolerance) { expect_identities(read_line_cases(path())); }

INSTANTIATE_TEST_SUITE_P(, Csg, testing::ValuesIn(families("csg")), family_name);

} // namespace
} // namespace rayscope::test
