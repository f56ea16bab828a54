#pragma once
// How a command ends that can't do what was asked.

#include <functional>
#include <stdexcept>

namespace rayscope::cli {

/// Exit codes: 0 done, 1 the work failed, 2 wrong input or usage, 130 interrupted by Ctrl-C.
inline constexpr int done = 0, failed = 1, wrong_usage = 2, interrupted = 130;

/// Arguments that can't be meant: exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A line of a script that can't be meant; what() begins with the script's name and the line: exit code 2.
struct ScriptError : UsageError {
    using UsageError::UsageError;
};

/// Says that Ctrl-C ended the command, and that nothing is left of it.
/// @return the exit code
[[nodiscard]] int stopped();

/// The exit code of `work`; of what it throws, after that was told on stderr.
[[nodiscard]] int guarded(const std::function<int()>& work);

} // namespace rayscope::cli
