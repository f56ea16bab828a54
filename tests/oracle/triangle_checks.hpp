#pragma once
// The check of all cases of a family of kind `tri`.

#include "core/cases/exact_cases.hpp"

namespace rayscope::test {

/// Expects t and the barycentric weights where a triangle is hit for certain, nothing where it is missed for certain or
/// lies along the line, and no gap between triangles that share an edge. Prints the first few that are wrong.
void expect_triangles(const std::vector<TriangleCase>& cases);

} // namespace rayscope::test
