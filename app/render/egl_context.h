// An OpenGL context without a display, for pictures and tests.
#pragma once

namespace whorl::app {

/// OpenGL 3.3 core through EGL's surfaceless platform: no display, no window, no default framebuffer; draw
/// into a Framebuffer. Current on the constructing thread from construction to destruction. One at a time:
/// they would share EGL's display, which the first to go closes.
class EglContext {
  public:
    /// @throws NoOpenGl if the machine gives no OpenGL 3.3.
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Makes the context current on the calling thread; no other thread may hold it.
    /// @throws std::runtime_error if EGL refuses.
    void make_current();
    /// Lets go of the context, so that another thread may make it current.
    void release();

  private:
    void close();

    void* display_ = nullptr;  // EGLDisplay
    void* context_ = nullptr;  // EGLContext
};

}  // namespace whorl::app
