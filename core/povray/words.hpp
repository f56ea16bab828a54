#pragma once
// Numbers, vectors and colours as POV-Ray reads them.

#include "core/math/transform.hpp"
#include "core/math/vec.hpp"

#include <string>

namespace rayscope::povray {

/// The shortest decimals that are read back as the same number. Throws std::range_error unless it is finite.
[[nodiscard]] std::string number(double x);

/// "<x, y, z>"
[[nodiscard]] std::string vector(const Vec3d& v);

/// "rgb <r, g, b>", or "rgb x" where the three are one number.
[[nodiscard]] std::string colour(const Colour& c);

/// "matrix <…>": POV-Ray multiplies row vectors, so its rows are our columns; the last column is left out.
[[nodiscard]] std::string matrix(const Mat4d& m);

/// The point that a matrix moves p to.
[[nodiscard]] Vec3d moved_point(const Mat4d& m, const Vec3d& p);

/// A text from outside as a comment that ends with its line.
[[nodiscard]] std::string comment(std::string_view text);

} // namespace rayscope::povray
