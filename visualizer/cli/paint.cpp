#include "visualizer/cli/paint.hpp"

#include <cstdlib>
#include <string_view>

#include <unistd.h>

namespace rayscope::cli {

std::string Paint::kind(RayKind kind, const std::string& text) const {
    // The nearest of the 256 terminal colours to the pictures' Okabe-Ito colours.
    switch (kind) {
    case RayKind::eye: return bold(text);
    case RayKind::reflected: return with("38;5;32", text);
    case RayKind::refracted: return with("38;5;166", text);
    case RayKind::shadow: return with("38;5;178", text);
    }
    return text;
}

bool wants_colours(int file_descriptor) {
    const char* no_colour = std::getenv("NO_COLOR");
    if (no_colour != nullptr && *no_colour != '\0') return false;
    const char* terminal = std::getenv("TERM");
    return isatty(file_descriptor) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

const char* name_of(RayKind kind) {
    switch (kind) {
    case RayKind::eye: return "eye";
    case RayKind::reflected: return "reflected";
    case RayKind::refracted: return "refracted";
    case RayKind::shadow: return "shadow";
    }
    return "";
}

} // namespace rayscope::cli
