// See program.h.
#include "app/render/program.h"

#include <stdexcept>
#include <string>

namespace whorl::app {
namespace {

GLuint compile(GLenum stage, std::string_view name, std::string_view source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    throw std::runtime_error("shader " + std::string(name) +
                             (stage == GL_VERTEX_SHADER ? ".vert: " : ".frag: ") + log);
}

}  // namespace

Program::Program(std::string_view name, std::string_view vertex, std::string_view fragment) {
    const GLuint vertex_shader = compile(GL_VERTEX_SHADER, name, vertex);
    GLuint fragment_shader = 0;
    try {
        fragment_shader = compile(GL_FRAGMENT_SHADER, name, fragment);
    } catch (...) {
        glDeleteShader(vertex_shader);
        throw;
    }
    name_ = glCreateProgram();
    glAttachShader(name_, vertex_shader);
    glAttachShader(name_, fragment_shader);
    glLinkProgram(name_);
    glDeleteShader(vertex_shader);
    glDeleteShader(fragment_shader);
    GLint good = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return;
    char log[2048] = "";
    glGetProgramInfoLog(name_, sizeof log, nullptr, log);
    glDeleteProgram(name_);
    throw std::runtime_error("shader program " + std::string(name) + ": " + log);
}

Program::~Program() {
    glDeleteProgram(name_);
}

}  // namespace whorl::app
