#pragma once
// The check of all cases of a family of kind `oct`.

#include "core/cases/exact_cases.hpp"

namespace rayscope::test {

/// Expects an octree's walk to visit the cells of the exact segments in order, and otherwise only cells that the ray
/// touches. Prints the first few that are wrong.
void expect_cells(const std::vector<GridCase>& cases);

} // namespace rayscope::test
