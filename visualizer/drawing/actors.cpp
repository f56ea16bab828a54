#include "visualizer/drawing/actors.hpp"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace rayscope::drawing {

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

} // namespace rayscope::drawing
