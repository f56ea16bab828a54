#pragma once
// OpenGL without any display: Mesa's surfaceless EGL platform, drawn by the processor.

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

/// A render window that never asks for an X server, which Debian's own class aborts without. Throws
/// std::runtime_error if EGL is missing. Draws by software, so that a picture is the same on every machine.
[[nodiscard]] vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_window(int width, int height);

} // namespace rayscope::drawing
