// A place to draw that is no window.
#pragma once

#include "app/render/gl_object.h"
#include "core/io/png.h"

namespace whorl::app {

/// @throws std::runtime_error if a size is not positive or beyond the driver's limit
void check_drawable(int width, int height);

/// RGBA8 colour target of `width × height` pixels.
class Framebuffer {
  public:
    /// @throws std::runtime_error as check_drawable
    Framebuffer(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Name of the colour texture, to show it through ImGui::Image (rows go bottom-up).
    GLuint texture() const { return colour_.name(); }

    /// Directs drawing here, with the viewport over all of it.
    void bind() const;
    /// The pixels, top row first, opaque. Leaves the framebuffer bindings as they were.
    Image read() const;

  private:
    int width_;
    int height_;
    GlTexture colour_;
    GlFramebuffer framebuffer_;
};

}  // namespace whorl::app
