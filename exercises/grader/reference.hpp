#pragma once
// What is right, and what is known to be wrong: the cases of a seed, and the answers of the solution and of the
// misconceptions to each.

#include "exercises/grader/case_runner.hpp"
#include "exercises/grader/exercise.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace rayscope::exercises {

struct Case {
    std::size_t group = 0; ///< index into Exercise::groups
    std::string about;
    std::string call; ///< encoded: the function's number and the arguments
    std::size_t function = 0;
    List arguments;
};

/// An exercise's cases for one seed.
struct Reference {
    const Exercise* exercise = nullptr;
    std::uint64_t seed = 0;
    std::filesystem::path program;
    std::vector<Case> cases;
    /// [0]: the solution's outcome of each case; then each misconception's.
    std::vector<std::vector<Outcome>> outcomes;
};

/// Compiles what is not compiled yet, and runs it. The exercise must outlive it.
/// Throws InputError where the exercise's own files are wrong.
[[nodiscard]] Reference make_reference(const Toolchain& toolchain, const Exercise& exercise,
                                       std::uint64_t seed);

/// What is wrong with a value that a judged exercise's function returned; empty if nothing is.
[[nodiscard]] std::string judged(CaseRunner& reference, const Case& asked, const Value& answer);

} // namespace rayscope::exercises
