#pragma once
// What is the same wherever a trace is told of, in words or drawn.

#include "core/rayscope.hpp"

#include <fmt/format.h>

namespace rayscope::exercises {

inline constexpr double drawing_width = 640;

[[nodiscard]] inline std::string vector_text(const Vec3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

/// "eye", "reflected", …, as in the trace's file.
[[nodiscard]] inline std::string_view name_of(RayKind kind) {
    return Words<RayKind>::list[std::size_t(kind)];
}

} // namespace rayscope::exercises
