#pragma once
// The commands of the program; each returns its exit code.

#include "exercises/program/context.hpp"

namespace rayscope::exercises {

/// The command that the options name.
[[nodiscard]] int run_command(const Context& context);

[[nodiscard]] int run(const Context& context, const Verify& command);

} // namespace rayscope::exercises
