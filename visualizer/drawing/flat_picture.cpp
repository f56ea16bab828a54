#include "visualizer/drawing/flat_picture.hpp"

#include "visualizer/drawing/averaged.hpp"
#include "visualizer/drawing/canvas_item.hpp"
#include "visualizer/drawing/egl_context.hpp"

#include <vtkContextActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace rayscope::drawing {

FlatPicture::FlatPicture(const PictureSize& size)
    : size_(size), window_(make_window(size.width * scale, size.height * scale)) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    vtkNew<vtkContextActor> actor;
    scene_ = actor->GetScene();
    renderer->AddActor(actor);
    window_->AddRenderer(renderer);
}

void FlatPicture::render() { window_->Render(); }

Raster FlatPicture::finish(Canvas canvas) {
    vtkNew<CanvasItem> item;
    item->show(std::move(canvas), size_.height, scale);
    scene_->AddItem(item);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    window_->GetPixelData(0, 0, size_.width * scale - 1, size_.height * scale - 1, 0, bytes, 0);
    return averaged(size_, bytes, scale);
}

} // namespace rayscope::drawing
