#pragma once
// The check of all cases of a family of kind `cavity`.

#include "core/cases/exact_cases.hpp"

namespace rayscope::test {

/// Expects each ray to be mirrored N times between six walls, as often on each pair as it is exact, to end where it
/// should and to carry all its light. Prints the first few that are wrong.
void expect_cavity(const std::vector<CavityCase>& cases);

} // namespace rayscope::test
