#pragma once
// How surfaces and strokes are lit, and how VTK's camera stands where a View's does: the same in pictures and windows.

#include "visualizer/drawing/view.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

/// Of data in view space, with its own colours.
[[nodiscard]] vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data, bool lit);

void aim(vtkCamera* camera, const View& view);

} // namespace rayscope::drawing
