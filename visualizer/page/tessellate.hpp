#pragma once
// A generic shape as triangles.

#include "visualizer/page/triangles.hpp"

namespace rayscope::page {

/// A ball of world space that a page shows; the radius is positive and finite.
struct Ball {
    Vec3d centre{0};
    double radius = 1;
};

/// @param around steps of a full turn; flat faces that are to be clipped are divided, too
/// @param shown a half space is a square of its plane around it
[[nodiscard]] Triangles tessellate(const Generic<double>& shape, const Mat4d& matrix, int around,
                                   bool clipped, const Ball& shown);

} // namespace rayscope::page
