// Drawing that leaves OpenGL's state to the next one as it found it.
#pragma once

#include <epoxy/gl.h>

namespace whorl::app {

/// Keeps viewport, scissor box, program, vertex array, array buffer, active texture unit and the switches for
/// blending, scissor, depth and culling for a scope. Inside, all four switches are off.
class GlStateGuard {
  public:
    GlStateGuard() {
        glGetIntegerv(GL_VIEWPORT, viewport_);
        glGetIntegerv(GL_SCISSOR_BOX, scissor_);
        glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertices_);
        glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer_);
        glGetIntegerv(GL_ACTIVE_TEXTURE, &unit_);
        glGetIntegerv(GL_BLEND_SRC_RGB, &blend_[0]);
        glGetIntegerv(GL_BLEND_DST_RGB, &blend_[1]);
        glGetIntegerv(GL_BLEND_SRC_ALPHA, &blend_[2]);
        glGetIntegerv(GL_BLEND_DST_ALPHA, &blend_[3]);
        for (int k = 0; k < 4; ++k) {
            on_[k] = glIsEnabled(switches[k]) == GL_TRUE;
            glDisable(switches[k]);
        }
    }
    ~GlStateGuard() {
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
        glUseProgram(static_cast<GLuint>(program_));
        glBindVertexArray(static_cast<GLuint>(vertices_));
        glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
        glActiveTexture(static_cast<GLenum>(unit_));
        glBlendFuncSeparate(static_cast<GLenum>(blend_[0]), static_cast<GLenum>(blend_[1]),
                            static_cast<GLenum>(blend_[2]), static_cast<GLenum>(blend_[3]));
        for (int k = 0; k < 4; ++k) {
            (on_[k] ? glEnable : glDisable)(switches[k]);
        }
    }
    GlStateGuard(const GlStateGuard&) = delete;
    GlStateGuard& operator=(const GlStateGuard&) = delete;

  private:
    static constexpr GLenum switches[4] = {GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE};

    GLint viewport_[4] = {};
    GLint scissor_[4] = {};
    GLint program_ = 0;
    GLint vertices_ = 0;
    GLint buffer_ = 0;
    GLint unit_ = 0;
    GLint blend_[4] = {};
    bool on_[4] = {};
};

}  // namespace whorl::app
