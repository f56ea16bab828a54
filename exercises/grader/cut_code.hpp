#pragma once
// Numbers of a trace as the C++ of a case.

#include "core/rayscope.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace rayscope::exercises {

/// A double, also where it is a whole number.
[[nodiscard]] inline std::string code(double number) {
    if (std::isinf(number)) return number > 0 ? "INF" : "-INF";
    return fmt::format("double({})", number);
}
[[nodiscard]] inline std::string code(const Vec3d& v) {
    return fmt::format("dvec3({}, {}, {})", code(v.x), code(v.y), code(v.z));
}
[[nodiscard]] inline std::string code(const SpanFound& span) {
    return fmt::format("{{{}, {}}}", code(span.enter.t), code(span.exit.t));
}
/// Items that are code already.
[[nodiscard]] inline std::string list_code(const std::string& type, const std::vector<std::string>& items) {
    return fmt::format("{}{{{}}}", type, fmt::join(items, ", "));
}

} // namespace rayscope::exercises
