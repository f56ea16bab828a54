#pragma once
// rayscope view: the window is a program of its own, since it needs Qt and VTK.

namespace rayscope::cli {

/// Becomes that program, which takes the words after "view". Returns an exit code only where there is none.
[[nodiscard]] int view(int count, char** arguments);

} // namespace rayscope::cli
