#pragma once
// How a command ends that can't do what was asked.

#include <stdexcept>

namespace rayscope::exercises {

/// Exit codes: 0 done, 1 the work failed, or not all is right yet, 2 wrong input or usage.
inline constexpr int done = 0, failed = 1, wrong_usage = 2;

/// Arguments that can't be meant: exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace rayscope::exercises
