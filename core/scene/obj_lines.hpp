#pragma once
// The lines of an OBJ file as a reader wants them.

#include <string>

namespace rayscope {

/// Without a byte order mark, without comments behind what v, vt, vn and f say, and with lines that a backslash continues
/// made one. Every line keeps its number: empty ones take the place of those that were continued.
[[nodiscard]] std::string tidied_obj(std::string text);

} // namespace rayscope
