#pragma once
// One generic shape at its place as a POV-Ray object.

#include "core/generics/generic.hpp"

#include <string>

namespace rayscope::povray {

/// @param matrix object → POV-Ray's space
/// @param modifiers textures and the like, which stand at the end
[[nodiscard]] std::string shape(const Generic<double>& generic, const Mat4d& matrix,
                                const std::string& modifiers);

} // namespace rayscope::povray
