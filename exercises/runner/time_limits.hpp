#pragma once
// How long a run of a program that nobody trusts may take.

#include <chrono>

namespace rayscope::runner {

/// Of the processor; and on the clock, far longer, so that a busy machine does not decide.
inline constexpr std::chrono::milliseconds most_computing{2000}, most_waiting{20000};

/// The same for a program that ran out of time once: it is not waited for as long again.
inline constexpr std::chrono::milliseconds later_computing{200}, later_waiting{4000};

/// So much waiting in all runs together, and it is not waited for as long either.
inline constexpr std::chrono::milliseconds most_waiting_in_all{40000};

} // namespace rayscope::runner
