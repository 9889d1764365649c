// Ownership of an OpenGL name.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace whorl::app {

/// Owns one OpenGL object of a kind; created empty, made on first need by `create`. The context that made it
/// must be current when it is destroyed.
template <class Kind>
class GlObject {
  public:
    GlObject() = default;
    static GlObject create() {
        GlObject object;
        Kind::generate(&object.name_);
        return object;
    }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_ != 0) Kind::destroy(&name_);
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

struct TextureKind {
    static void generate(GLuint* name) { glGenTextures(1, name); }
    static void destroy(const GLuint* name) { glDeleteTextures(1, name); }
};
struct FramebufferKind {
    static void generate(GLuint* name) { glGenFramebuffers(1, name); }
    static void destroy(const GLuint* name) { glDeleteFramebuffers(1, name); }
};
struct VertexArrayKind {
    static void generate(GLuint* name) { glGenVertexArrays(1, name); }
    static void destroy(const GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct BufferKind {
    static void generate(GLuint* name) { glGenBuffers(1, name); }
    static void destroy(const GLuint* name) { glDeleteBuffers(1, name); }
};

using GlTexture = GlObject<TextureKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlBuffer = GlObject<BufferKind>;

}  // namespace whorl::app
