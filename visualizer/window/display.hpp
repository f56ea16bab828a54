#pragma once
// Whether there is a screen to open a window on. Apart from Qt: Xlib's macros and its names clash.

namespace rayscope::window {

/// Asked before Qt and VTK are touched: both end the process where there is none.
[[nodiscard]] bool has_display();

} // namespace rayscope::window
