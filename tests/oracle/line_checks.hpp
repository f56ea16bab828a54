#pragma once
// The checks of all cases of a family of kind `hit` or `csg`.

#include "core/math/numbers.hpp"
#include "tests/oracle/accuracy.hpp"
#include "tests/oracle/case_files.hpp"

namespace rayscope::test {

/// The ends of the spans that are to be compared one by one; empty where the case can't be decided.
[[nodiscard]] std::vector<MatchedEnd> comparable_ends(const LineCase& exact, const FoundSpans& found);

/// Each expects the core, in these numbers, to be right about every case, and prints the first few that are wrong.
void expect_spans(const std::vector<LineCase>& cases, NumbersChoice numbers = {});
void expect_surfaces_and_normals(const std::vector<LineCase>& cases, NumbersChoice numbers = {});
void expect_bounds_of_ends(const std::vector<LineCase>& cases, NumbersChoice numbers);
void expect_first_hits(const std::vector<LineCase>& cases);
void expect_error_bounds(const std::vector<LineCase>& cases);
/// A compound of one leaf is empty, everything, the leaf or its complement, bit for bit.
void expect_identities(const std::vector<LineCase>& cases);

/// Errors and bounds of all comparable ends.
[[nodiscard]] Accuracy accuracy_of(const std::vector<LineCase>& cases);

} // namespace rayscope::test
