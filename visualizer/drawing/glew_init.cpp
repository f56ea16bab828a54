// Debian's GLEW is built for X: under EGL glewInit() loads every function and then reports "no GLX display" (4),
// which VTK takes for a failure. This definition stands before the library's, since the programs export it.

#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) unsigned glewInit();

extern "C" unsigned glewInit() {
    constexpr unsigned failed = 1, no_glx_display = 4;
    using Function = unsigned (*)();
    const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glewInit"));
    const unsigned result = original != nullptr ? original() : failed;
    return result == no_glx_display ? 0 : result;
}
