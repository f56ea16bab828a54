#pragma once
// The check of all cases of a family of kind `refr`.

#include "core/cases/exact_cases.hpp"
#include "core/math/numbers.hpp"

namespace rayscope::test {

/// Expects total internal reflection, refracted and mirrored direction to be right, and prints the first few
/// that are not. Where total reflection can't be decided, either answer is right.
void expect_refraction(const std::vector<RefractionCase>& cases, NumbersChoice numbers = {});

} // namespace rayscope::test
