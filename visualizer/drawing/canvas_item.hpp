#pragma once
// Paints a canvas over the picture.

#include "visualizer/drawing/canvas.hpp"

#include <vtkContextItem.h>

namespace rayscope::drawing {

class CanvasItem : public vtkContextItem {
public:
    static CanvasItem* New();
    vtkTypeMacro(CanvasItem, vtkContextItem);

    /// @param scale pixels of the window for each pixel of the canvas
    void show(Canvas canvas, int height, int scale);
    bool Paint(vtkContext2D* painter) override;

private:
    Canvas canvas_;
    int height_ = 0, scale_ = 1;
};

} // namespace rayscope::drawing
