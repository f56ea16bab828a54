#pragma once
// The commands of the program; each returns its exit code.

#include "exercises/program/context.hpp"

namespace rayscope::exercises {

/// The command that the options name.
[[nodiscard]] int run_command(const Context& context);

[[nodiscard]] int run(const Context& context, const Start& command);
[[nodiscard]] int run(const Context& context, const Watch& command);
[[nodiscard]] int run(const Context& context, const ListExercises& command);
[[nodiscard]] int run(const Context& context, const Check& command);
[[nodiscard]] int run(const Context& context, const CheckAll& command);
[[nodiscard]] int run(const Context& context, const Hint& command);
[[nodiscard]] int run(const Context& context, const Reset& command);
[[nodiscard]] int run(const Context& context, const ShowSolution& command);
[[nodiscard]] int run(const Context& context, const Next& command);
[[nodiscard]] int run(const Context& context, const Predict& command);
[[nodiscard]] int run(const Context& context, const Verify& command);
[[nodiscard]] int run(const Context& context, const GradeAll& command);
[[nodiscard]] int run(const Context& context, const Package& command);
[[nodiscard]] int run(const Context& context, const New& command);
[[nodiscard]] int run(const Context& context, const RenderWith& command);
[[nodiscard]] int run(const Context& context, const StepWith& command);

} // namespace rayscope::exercises
