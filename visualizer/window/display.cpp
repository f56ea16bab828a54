#include "visualizer/window/display.hpp"

#include <X11/Xlib.h>

namespace rayscope::window {

bool has_display() {
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) return false;
    XCloseDisplay(display);
    return true;
}

} // namespace rayscope::window
