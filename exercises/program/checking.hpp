#pragma once
// A student's file, checked: compiled while the reference is made.

#include "exercises/grader/grade.hpp"
#include "exercises/program/context.hpp"
#include "exercises/program/workspace.hpp"

namespace rayscope::exercises {

struct Checked {
    Reference reference;
    Grade grade;
    std::string text; ///< for the student
};

/// Checks the file. With a workspace the scenes of a wrong case's ray are put there, and points are entered.
[[nodiscard]] Checked check(const Context& context, const Toolchain& toolchain, const Exercise& exercise,
                            const std::filesystem::path& file, const Workspace* workspace);

} // namespace rayscope::exercises
