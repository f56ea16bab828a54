#pragma once
// How VTK's filters find points that are the same.

#include <vtkMergePoints.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace rayscope::drawing {

/// With a bucket for each of so many points. A filter's own has 125,000, which take longer to clear than most surfaces
/// take to work on.
[[nodiscard]] inline vtkSmartPointer<vtkMergePoints> merging(vtkIdType points) {
    const int edge = std::clamp(int(std::cbrt(double(points))), 1, 50);
    auto locator = vtkSmartPointer<vtkMergePoints>::New();
    locator->SetDivisions(edge, edge, edge);
    return locator;
}

} // namespace rayscope::drawing
