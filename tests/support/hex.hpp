#pragma once
// Numbers as hexadecimal floats: what a failing test prints can be pasted back into code without losing a bit.

#include "core/math/ray.hpp"

#include <cstdio>
#include <string>

namespace rayscope::test {

[[nodiscard]] inline std::string hex(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

// Appended to a string, not to a literal: GCC 12 warns of an overlap there that is none (-Wrestrict).
[[nodiscard]] inline std::string hex(const Vec3d& v) {
    std::string text = "{";
    return text.append(hex(v.x)).append(", ").append(hex(v.y)).append(", ").append(hex(v.z)).append("}");
}

[[nodiscard]] inline std::string hex(const Ray<double>& ray) {
    std::string text = "{";
    return text.append(hex(ray.origin)).append(", ").append(hex(ray.direction)).append("}");
}

/// Column by column, as glm keeps it.
[[nodiscard]] inline std::string hex(const Mat4d& m) {
    std::string text = "{";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) text += (column + row > 0 ? ", " : "") + hex(m[column][row]);
    return text + "}";
}

} // namespace rayscope::test
