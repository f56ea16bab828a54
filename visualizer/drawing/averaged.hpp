#pragma once
// From a window that is larger than the picture to the picture.

#include "visualizer/drawing/picture.hpp"

#include <vtkUnsignedCharArray.h>

namespace rayscope::drawing {

/// Each pixel is the mean of oversampling × oversampling of the window's: everything is smooth.
[[nodiscard]] Raster averaged(const PictureSize& size, vtkUnsignedCharArray* pixels, int oversampling);

} // namespace rayscope::drawing
