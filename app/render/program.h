// A shader program.
#pragma once

#include <epoxy/gl.h>

#include <string_view>

namespace whorl::app {

/// A linked vertex and fragment shader. Needs a current OpenGL 3.3 context, at destruction too.
class Program {
  public:
    /// @param name  what error messages call it
    /// @throws std::runtime_error with the driver's log if a shader does not compile or link.
    Program(std::string_view name, std::string_view vertex, std::string_view fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(name_); }
    /// Location of a uniform, -1 (which OpenGL ignores) if the linker found no use for it.
    GLint uniform(const char* uniform_name) const { return glGetUniformLocation(name_, uniform_name); }

  private:
    GLuint name_ = 0;
};

}  // namespace whorl::app
