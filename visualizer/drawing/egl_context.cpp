#include "visualizer/drawing/egl_context.hpp"

#define EGL_EGLEXT_PROTOTYPES
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace rayscope::drawing {
namespace {

/// Opened once and kept to the end of the process: VTK frees its GL objects late.
void make_context_current() {
    static const bool done = [] {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (get_display == nullptr) throw std::runtime_error("this EGL has no platform displays");
        const EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
            eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
            throw std::runtime_error("EGL could not be started (is libegl-mesa0 installed?)");

        constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                               EGL_OPENGL_BIT, EGL_NONE};
        constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                2,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
        constexpr std::array<EGLint, 5> size{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint found = 0;
        eglChooseConfig(display, wanted.data(), &config, 1, &found);
        const EGLContext context =
            found > 0 ? eglCreateContext(display, config, EGL_NO_CONTEXT, version.data()) : EGL_NO_CONTEXT;
        if (context == EGL_NO_CONTEXT) throw std::runtime_error("EGL has no OpenGL 3.2 here");
        const EGLSurface surface = eglCreatePbufferSurface(display, config, size.data());
        if (eglMakeCurrent(display, surface, surface, context) == EGL_FALSE)
            throw std::runtime_error("EGL's context can't be made current");
        return true;
    }();
    static_cast<void>(done);
}

} // namespace

vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_window(int width, int height) {
    make_context_current();
    auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window->SetReadyForRendering(true);
    window->SetIsCurrent(true);
    window->SetSupportsOpenGL(1);
    window->SetOwnContext(0);
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0); // with it, depth peeling silently drops everything translucent
    window->SetAlphaBitPlanes(1);
    window->SetSize(width, height);
    window->OpenGLInitContext();
    return window;
}

} // namespace rayscope::drawing
