// See egl_context.h.
#include "app/render/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/render/no_opengl.h"

namespace whorl::app {
namespace {

[[noreturn]] void fail(std::string_view what) {
    throw NoOpenGl("no OpenGL 3.3 without a display: " + std::string(what));
}

bool has_extension(const char* list, std::string_view name) {
    std::istringstream words(list != nullptr ? list : "");
    for (std::string word; words >> word;) {
        if (word == name) return true;
    }
    return false;
}

}  // namespace

EglContext::EglContext() {
    if (!has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
        fail("EGL has no surfaceless platform (install Mesa's EGL driver, libegl-mesa0 and libgl1-mesa-dri)");
    }
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) fail("EGL lacks eglGetPlatformDisplayEXT");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
        display_ = nullptr;
        fail("EGL finds no driver (install libgl1-mesa-dri)");
    }
    try {
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("EGL has no desktop OpenGL");
        const EGLint config_wants[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, config_wants, &config, 1, &count) == EGL_FALSE || count == 0) {
            fail("EGL offers no OpenGL configuration");
        }
        const EGLint context_wants[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        3,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, context_wants);
        if (context_ == EGL_NO_CONTEXT) fail("the driver offers an older version only");
        make_current();
    } catch (...) {
        close();
        throw;
    }
}

EglContext::~EglContext() {
    close();
}

void EglContext::make_current() {
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
        fail("the context cannot be made current");
    }
}

void EglContext::release() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void EglContext::close() {
    if (display_ == nullptr) return;
    release();
    if (context_ != nullptr) eglDestroyContext(display_, context_);
    eglTerminate(display_);
    display_ = nullptr;
    context_ = nullptr;
}

}  // namespace whorl::app
