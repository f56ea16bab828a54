#pragma once
// A student's function in place of one of the tracer's formulas.

#include "core/rayscope.hpp"
#include "exercises/grader/exercise.hpp"
#include "exercises/grader/toolchain.hpp"

#include <chrono>
#include <memory>
#include <vector>

namespace rayscope::exercises {

/// The exercises whose function can stand for a formula of the tracer.
[[nodiscard]] std::vector<const Exercise*> with_formulas(const std::vector<Exercise>& catalogue);

/// The formula that the exercise asks for, computed by the program in the sandbox. A program that gives no answer makes
/// the formula throw std::runtime_error.
/// @param in_all after so much time it gives no answer any more
[[nodiscard]] Formulas served_formulas(const Toolchain& toolchain, const Exercise& exercise,
                                       const std::filesystem::path& program, std::chrono::seconds in_all);

} // namespace rayscope::exercises
