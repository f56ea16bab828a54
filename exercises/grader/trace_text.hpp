#pragma once
// What is told of a trace in words.

#include "core/rayscope.hpp"

#include <fmt/format.h>

namespace rayscope::exercises {

[[nodiscard]] inline std::string vector_text(const Vec3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

/// "eye", "reflected", …, as in the trace's file.
[[nodiscard]] inline std::string_view name_of(RayKind kind) {
    return Words<RayKind>::list[std::size_t(kind)];
}

} // namespace rayscope::exercises
