#pragma once
// Pictures without a world: charts and panels.

#include "visualizer/drawing/canvas.hpp"
#include "visualizer/drawing/picture.hpp"

#include <vtkContextScene.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

/// Items of VTK's own, in the window's pixels, and a canvas over them, in the picture's.
class FlatPicture {
public:
    explicit FlatPicture(const PictureSize& size);

    /// Pixels of the window for each of the picture.
    static constexpr int scale = 2;

    [[nodiscard]] vtkContextScene* scene() const { return scene_; }
    /// Lays out and draws what is there: then items know where they are.
    void render();
    /// Call it once, when all items are in their places.
    [[nodiscard]] Raster finish(Canvas canvas);

private:
    PictureSize size_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    vtkContextScene* scene_ = nullptr; // of the window's actor
};

} // namespace rayscope::drawing
