#include "visualizer/drawing/raster.hpp"

#include "visualizer/drawing/actors.hpp"
#include "visualizer/drawing/averaged.hpp"
#include "visualizer/drawing/canvas_item.hpp"
#include "visualizer/drawing/egl_context.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace rayscope::drawing {
namespace {

constexpr int oversampling = 2, peels = 8;
constexpr double nearest = 0.2, farthest = 150; // in radii of the region

} // namespace

Raster rasterize(const PictureSize& size, const View& view, const PaintedSurfaces& surfaces,
                 const Mesh& strokes, const Canvas& canvas, double pixels) {
    const int width = size.width * oversampling, height = size.height * oversampling;
    const auto window = make_window(width, height);
    window->SetNumberOfLayers(2);

    vtkNew<vtkRenderer> world;
    const Area& area = view.area();
    world->SetViewport(area.x / size.width, 1 - area.bottom() / size.height, area.right() / size.width,
                       1 - area.y / size.height);
    world->SetBackground(sky.red / 255.0, sky.green / 255.0, sky.blue / 255.0);
    world->SetUseDepthPeeling(1);
    world->SetMaximumNumberOfPeels(peels);
    world->SetOcclusionRatio(0);
    world->AddActor(actor_of(surfaces.floors, false));
    world->AddActor(actor_of(surfaces.faces, true));
    const auto outlines = actor_of(surfaces.outlines, false);
    outlines->GetProperty()->SetLineWidth(float(1.3 * pixels * oversampling));
    world->AddActor(outlines);
    world->AddActor(actor_of(strokes.polydata(), true));
    aim(world->GetActiveCamera(), view);
    // By hand: fitted to all that there is, a floor without end would push the near plane behind the region.
    world->GetActiveCamera()->SetClippingRange(nearest, length(view.position()) + farthest);
    window->AddRenderer(world);

    vtkNew<vtkRenderer> overlay;
    overlay->SetLayer(1);
    overlay->InteractiveOff();
    vtkNew<CanvasItem> item;
    item->show(canvas, size.height, oversampling);
    vtkNew<vtkContextActor> panels;
    panels->GetScene()->AddItem(item);
    overlay->AddActor(panels);
    window->AddRenderer(overlay);

    window->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    window->GetPixelData(0, 0, width - 1, height - 1, 0, bytes, 0);
    return averaged(size, bytes, oversampling);
}

} // namespace rayscope::drawing
