#pragma once
// NFF's `c`: a cone or cylinder without caps between two circles.

#include "core/scene/scene.hpp"

#include <optional>

namespace rayscope {

struct TubeEnd {
    Vec3d centre{0};
    double radius = 0;
};

struct PlacedTube {
    Generic<double> shape; ///< OpenCylinder or OpenCone
    Mat4d matrix{1};
};

/// The canonical shape and the matrix that brings it between the two circles. Negative radii count as positive
/// ones. Nothing if the ends are one point, both radii are zero, or the sizes leave the range of numbers.
[[nodiscard]] std::optional<PlacedTube> place_tube(TubeEnd base, TubeEnd apex);

} // namespace rayscope
