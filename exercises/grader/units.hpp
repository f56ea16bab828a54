#pragma once
// The texts that make a program of an exercise's files.

#include "exercises/grader/exercise.hpp"
#include "exercises/grader/toolchain.hpp"

namespace rayscope::exercises {

/// A student's file, or one that is treated like it. Diagnostics name it Exercise::file_name().
[[nodiscard]] Unit answer_unit(const Exercise& exercise, const std::string& code, bool sanitized = false);

/// The cases, with one variant of the exercise's functions after the other. Throws InputError where cases.cpp can't be
/// read.
struct Variant {
    std::string name, code; ///< the name is for diagnostics
};
[[nodiscard]] Unit variants_unit(const Exercise& exercise, const std::vector<Variant>& variants);

/// The same of the solution, variant 0, and the misconceptions. Throws InputError where a file can't be read.
[[nodiscard]] Unit reference_unit(const Exercise& exercise);

/// A file of at most a MiB. Throws InputError.
[[nodiscard]] std::string read_code(const std::filesystem::path& path);

} // namespace rayscope::exercises
