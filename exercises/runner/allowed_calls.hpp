#pragma once
// What a program with a student's code may ask of the kernel.

namespace rayscope::runner {

/// From now on this process may compute, use memory, and read and write what is open; all else fails with EPERM: no
/// files are created, no processes or threads started, nobody is traced or signalled but itself, no network. One
/// more program may be started in its place, which inherits all this. False where the kernel knows no such filter.
[[nodiscard]] bool allow_only_computing();

} // namespace rayscope::runner
