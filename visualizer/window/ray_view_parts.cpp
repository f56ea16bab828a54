#include "visualizer/window/ray_view_parts.hpp"

#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/window/known_part.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkLightsPass.h>
#include <vtkMapper.h>
#include <vtkOpaquePass.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include <algorithm>

namespace rayscope::window {
namespace {

constexpr int peels = 4;
constexpr double nearest = 0.2, farthest = 150; // in radii of what is seen

void put(vtkActor* actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(data);
}

bool same_objects(const drawing::Surfaces& surfaces, const std::vector<Id>& drawn) {
    return std::ranges::all_of(drawn, [&](Id id) {
        return id == none || std::ranges::any_of(surfaces.shown, [&](const drawing::Surface& surface) {
                   return surface.drawn == std::size_t(id) && surface.hit;
               });
    });
}

bool same_places(const Scene& a, const Scene& b) {
    return &a == &b ||
           (std::ranges::equal(a.generics, b.generics, {}, &SceneGeneric::matrix, &SceneGeneric::matrix));
}

} // namespace

RayView::Scenery::Scenery(const Workbench& workbench, const Trace& trace,
                          const std::set<std::size_t>& exploded, const Scenery* old) {
    const std::vector<Id> drawn = drawing::drawn_objects(trace, workbench.scene);
    const drawing::Region fresh = drawing::region_of(trace, workbench, drawn);
    // The camera stays while the new trace lies about where the old one did.
    const bool near = old != nullptr && old->region.holds(fresh.centre, 1.6) &&
                      fresh.radius < 3 * old->region.radius && fresh.radius > old->region.radius / 8;
    moved = old != nullptr && !near;
    whole = is_finished(trace.rays.front());
    region = near ? old->region : fresh;
    // Of what the window itself changes, only the places of generics are seen in the shapes. Of a trace that is known in
    // part other objects count as hit.
    if (near && whole && old->whole && same_objects(old->surfaces, drawn) &&
        same_places(old->bench->scene, workbench.scene))
        surfaces = old->surfaces;
    else
        surfaces = drawing::surfaces_near(workbench, trace, drawn, region);
    for (const std::size_t id : exploded)
        for (auto& operand : operands_of(workbench.scene, id, region)) operands.push_back(std::move(operand));
}

RayView::Actors::Actors() {
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(2);
    window->AddRenderer(world);
    window->AddRenderer(overlay);
    world->SetBackground(drawing::sky.red / 255.0, drawing::sky.green / 255.0, drawing::sky.blue / 255.0);
    world->SetUseDepthPeeling(1);
    world->SetMaximumNumberOfPeels(peels);
    world->SetOcclusionRatio(0);
    world->SetUseFXAA(true);
    const vtkNew<vtkPolyData> nothing;
    floors = drawing::actor_of(nothing, false);
    faces = drawing::actor_of(nothing, true);
    outlines = drawing::actor_of(nothing, false);
    outlines->GetProperty()->SetLineWidth(1.5F);
    strokes = drawing::actor_of(nothing, true);
    for (vtkActor* actor : {floors.Get(), faces.Get(), outlines.Get(), strokes.Get()}) world->AddActor(actor);
    // VTK's own way without peeling sorts translucent fragments, in several passes over the whole view.
    const vtkNew<vtkRenderPassCollection> parts;
    parts->AddItem(vtkNew<vtkLightsPass>());
    parts->AddItem(vtkNew<vtkOpaquePass>());
    parts->AddItem(vtkNew<vtkTranslucentPass>());
    const vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(parts);
    coarse->SetDelegatePass(sequence);
    overlay->SetLayer(1);
    overlay->InteractiveOff();
    vtkNew<vtkContextActor> labels;
    labels->GetScene()->AddItem(canvas);
    overlay->AddActor(labels);
}

void RayView::Actors::show_surfaces(const drawing::PaintedSurfaces& painted) {
    put(floors, painted.floors);
    put(faces, painted.faces);
    put(outlines, painted.outlines);
}

void RayView::Actors::show_strokes(const drawing::Mesh& mesh) { put(strokes, mesh.polydata()); }

void RayView::Actors::show_canvas(drawing::Canvas shapes, int height, int scale) {
    canvas->show(std::move(shapes), height, scale);
    show_labels(true);
}

void RayView::Actors::show_labels(bool on) { canvas->SetVisible(on); }

void RayView::Actors::look(const Vec3d& position, const Vec3d& focus, const Vec3d& up) {
    vtkCamera* camera = world->GetActiveCamera();
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(up.x, up.y, up.z);
}

void RayView::Actors::draw_finely(bool fine) {
    world->SetUseDepthPeeling(fine);
    world->SetUseFXAA(fine);
    world->SetPass(fine ? nullptr : coarse.Get());
}

void RayView::Actors::clip(const drawing::View& view, double seen, double all) {
    // By hand: fitted to all that there is, a floor without end would push the near plane behind the rays.
    const double more = std::clamp(8 * all / seen, 0.0, 1e4);
    world->GetActiveCamera()->SetClippingRange(nearest, length(view.position()) + farthest + more);
}

} // namespace rayscope::window
