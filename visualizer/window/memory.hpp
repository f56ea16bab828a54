#pragma once
// The memory of this process.

namespace rayscope::window {

/// Resident, in megabytes.
[[nodiscard]] double resident_memory();

/// What was freed goes back to the system.
void give_back_memory();

} // namespace rayscope::window
