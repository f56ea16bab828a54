#pragma once
// Ctrl-C, for commands that work for long.

#include <atomic>

namespace rayscope::cli {

/// Set by Ctrl-C, once interrupts are caught.
extern std::atomic<bool> stop_asked_for;

/// From now on Ctrl-C only sets stop_asked_for, and lets a file that is being written become whole. Before, it ends the
/// program at once, and nothing is there yet that could be broken.
void catch_interrupts();

} // namespace rayscope::cli
