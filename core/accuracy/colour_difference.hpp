#pragma once
// How different two colours look.

#include "core/math/vec.hpp"

namespace rayscope {

/// CIE L*a*b* of the D65 white, in the vector's components.
[[nodiscard]] Vec3d lab_of(const Colour& linear_srgb);

/// CIEDE2000 of two L*a*b* colours, all weights 1: about 1 is just visible side by side.
/// Source: Sharma, Wu, Dalal 2005, "The CIEDE2000 color-difference formula".
[[nodiscard]] double ciede2000(const Vec3d& lab, const Vec3d& other);

} // namespace rayscope
