#include "visualizer/drawing/raster.hpp"

#include "visualizer/drawing/averaged.hpp"
#include "visualizer/drawing/canvas_item.hpp"
#include "visualizer/drawing/egl_context.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace rayscope::drawing {
namespace {

constexpr int oversampling = 2, peels = 8;
constexpr double nearest = 0.2, farthest = 150; // in radii of the region

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data, bool lit) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(lit);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetAmbient(0.62);
    actor->GetProperty()->SetDiffuse(0.42);
    return actor;
}

void aim(vtkCamera* camera, const View& view) {
    const Vec3d position = view.position(), focus = position - view.back(), up = view.up();
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(view.field_of_view());
}

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
