#pragma once
// Whether an exercise tests what it says.

#include "exercises/grader/exercise.hpp"
#include "exercises/grader/toolchain.hpp"

namespace rayscope::exercises {

/// What is wrong with the exercise, in sentences; empty if nothing is. For each seed:
/// - the stub compiles and has no point in any group;
/// - the solution has all points, also under the sanitizers;
/// - where cases are shown, each has a scene that can be drawn;
/// - each misconception compiles, loses points in the groups that it names, and is the one that is recognised, also
///   with its variables renamed.
[[nodiscard]] std::vector<std::string> problems_of(const Toolchain& toolchain, const Exercise& exercise,
                                                   const std::vector<std::uint64_t>& seeds);

/// The code with other names for its parameters and local variables.
[[nodiscard]] std::string renamed(const std::string& code, const Exercise& exercise);

} // namespace rayscope::exercises
