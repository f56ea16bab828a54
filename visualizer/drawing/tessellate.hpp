#pragma once
// A generic shape as triangles and quads: made in object space, moved into the world by its matrix.

#include "visualizer/drawing/region.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace rayscope::drawing {

using Pieces = std::vector<vtkSmartPointer<vtkPolyData>>;

/// How many cells go around a full turn; flat faces get half as many along a side if they are to be clipped.
struct Fineness {
    int around = 96;
    bool clipped = false;
};

/// One piece for each smooth face, so that the pieces' boundaries are the shape's rims. World points (double) with
/// unit outward normals. A half space is a patch of its plane around the region, in squares of a round size whose
/// cell array "checker" alternates.
[[nodiscard]] Pieces tessellate(const Generic<double>& shape, const Mat4d& matrix, const Fineness& fineness,
                                const Region& region);

/// A round number (1, 2 or 5 times a power of ten) near `size`.
[[nodiscard]] double round_size(double size);

} // namespace rayscope::drawing
