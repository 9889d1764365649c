// See framebuffer.h.
#include "app/render/framebuffer.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace whorl::app {

void check_drawable(int width, int height) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit) {
        throw std::runtime_error("cannot draw a picture of " + std::to_string(width) + " × " +
                                 std::to_string(height) + " pixels: the limit is " + std::to_string(limit));
    }
}

Framebuffer::Framebuffer(int width, int height) : width_(width), height_(height) {
    check_drawable(width, height);
    GLint bound_texture = 0;
    GLint bound_framebuffer = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound_texture);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_framebuffer);
    colour_ = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, colour_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    framebuffer_ = GlFramebuffer::create();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_framebuffer));
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound_texture));
    if (!complete) throw std::runtime_error("the OpenGL driver refuses an off-screen picture");
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
}

Image Framebuffer::read() const {
    Image image{width_, height_, std::vector<std::uint8_t>(std::size_t{4} * width_ * height_)};
    GLint bound = 0;
    GLint alignment = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glPixelStorei(GL_PACK_ALIGNMENT, alignment);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));

    const std::size_t stride = std::size_t{4} * width_;
    for (int low = 0, high = height_ - 1; low < high; ++low, --high) {
        std::swap_ranges(image.rgba.begin() + low * stride, image.rgba.begin() + (low + 1) * stride,
                         image.rgba.begin() + high * stride);
    }
    for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;
    return image;
}

}  // namespace whorl::app
