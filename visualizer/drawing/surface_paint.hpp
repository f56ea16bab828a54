#pragma once
// Surfaces in view space, with their colours: translucent, so that the rays inside can be followed, and outlined.

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/surfaces.hpp"
#include "visualizer/drawing/view.hpp"

namespace rayscope::drawing {

struct PaintedSurfaces {
    vtkSmartPointer<vtkPolyData> faces;    ///< lit; point colours RGBA
    vtkSmartPointer<vtkPolyData> floors;   ///< not lit; cell colours RGBA
    vtkSmartPointer<vtkPolyData> outlines; ///< lines: rims and silhouettes; cell colours RGB
};

[[nodiscard]] PaintedSurfaces paint_surfaces(const Surfaces& surfaces, const Scene& scene, const View& view);

} // namespace rayscope::drawing
