#pragma once
// What the 3D view is made of.

#include "visualizer/drawing/actors.hpp"
#include "visualizer/drawing/canvas_item.hpp"
#include "visualizer/drawing/surface_paint.hpp"
#include "visualizer/window/explode.hpp"
#include "visualizer/window/ray_view.hpp"

#include <vtkCameraPass.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace rayscope::window {

struct RayView::Scenery {
    /// @param old a scenery whose region may stay, so that pixels can be compared
    Scenery(const Workbench& bench, const Trace& trace, const std::set<std::size_t>& exploded,
            const Scenery* old);

    std::shared_ptr<const Workbench> bench; // that the indices are of
    drawing::Region region;
    drawing::Surfaces surfaces;
    std::vector<drawing::Surface> operands;
    bool moved = false; ///< the trace lies elsewhere than the old one
    bool whole = false; ///< the trace has its end
};

struct RayView::Actors {
    Actors();

    void show_surfaces(const drawing::PaintedSurfaces& painted);
    void show_strokes(const drawing::Mesh& mesh);
    void show_canvas(drawing::Canvas canvas, int height, int scale);
    void show_labels(bool on);
    void look(const Vec3d& position, const Vec3d& focus, const Vec3d& up);
    /// Translucent things in their right order, and smooth edges; or blended in any order, which is much quicker.
    void draw_finely(bool fine);
    void clip(const drawing::View& view, double seen, double all);

    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkRenderer> world, overlay;
    vtkSmartPointer<vtkActor> floors, faces, outlines, strokes;
    vtkNew<vtkCameraPass> coarse;
    vtkNew<drawing::CanvasItem> canvas;
    vtkSmartPointer<vtkPolyData> rays, hits; // of the trace
    drawing::Surfaces named;                 // what is shown
};

} // namespace rayscope::window
