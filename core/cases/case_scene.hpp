#pragma once
// A case's line and solids as a scene of one drawn object.

#include "core/cases/exact_cases.hpp"
#include "core/scene/scene.hpp"

namespace rayscope {

/// Its leaves are the generics, named leaf0, leaf1 …, in the case's order; none sends a ray on.
[[nodiscard]] Scene scene_of(const LineCase& exact);

} // namespace rayscope
