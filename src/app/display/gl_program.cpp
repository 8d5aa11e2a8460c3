#include "gl_program.h"

#include "../embedded.h"

#include <teapath/core/error.h>

#include <glad/gl.h>

#include <string>

namespace tp {
namespace {

unsigned compile(unsigned kind, std::string_view file) {
    const std::string_view text = embedded_file(file);
    const char* begin = text.data();
    const auto length = static_cast<GLint>(text.size());
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &begin, &length);
    glCompileShader(shader);
    return shader;
}

// The driver's words about a shader or program.
template <class Get>
std::string log_of(unsigned object, const Get& get) {
    std::string log(1024, '\0');
    GLsizei length = 0;
    get(object, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    return log;
}

}  // namespace

GlProgram::GlProgram(std::string_view vertex, std::string_view fragment) {
    id_ = glCreateProgram();
    const unsigned shaders[] = {compile(GL_VERTEX_SHADER, vertex),
                                compile(GL_FRAGMENT_SHADER, fragment)};
    std::string log;
    for (const unsigned shader : shaders) {
        glAttachShader(id_, shader);
        log += log_of(shader, glGetShaderInfoLog);
        glDeleteShader(shader);
    }
    glLinkProgram(id_);
    GLint linked = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked) return;
    log += log_of(id_, glGetProgramInfoLog);
    glDeleteProgram(id_);
    throw Error(ErrorKind::Device,
                "the graphics driver refuses " + std::string(vertex) + " with " +
                    std::string(fragment) + ": " + log,
                "", "install a newer graphics driver, or start it with LIBGL_ALWAYS_SOFTWARE=1");
}

GlProgram::~GlProgram() {
    glDeleteProgram(id_);
}

}  // namespace tp
