#pragma once
// What all commands stand on: the catalogue, and the compiler in its sandbox.

#include "exercises/grader/exercise.hpp"
#include "exercises/grader/toolchain.hpp"
#include "exercises/program/options.hpp"

#include <memory>

namespace rayscope::exercises {

inline constexpr std::uint64_t practice_seed = 1;

struct Context {
    Options options;
    std::vector<Exercise> catalogue;

    [[nodiscard]] std::uint64_t seed() const { return options.seed.value_or(practice_seed); }
};

/// Reads the catalogue. Throws InputError.
[[nodiscard]] Context make_context(const Options& options);

/// Says on stderr where there is no sandbox. Throws UsageError where there is none and --unsafe is not given.
[[nodiscard]] std::unique_ptr<Toolchain> make_toolchain(const Context& context);

} // namespace rayscope::exercises
