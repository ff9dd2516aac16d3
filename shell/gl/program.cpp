// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/program.h"

#include "core/base/error.h"

namespace sightline {

namespace {

void compile(GLuint shader, const std::string& source) {
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return;
    std::string words(1024, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &length, words.data());
    words.resize(static_cast<std::size_t>(length));
    throw WorkError("the OpenGL driver refuses a shader: " + words);
}

}  // namespace

GlProgram make_program(const std::string& vertex, const std::string& fragment) {
    GlVertexShader vertex_shader;
    GlFragmentShader fragment_shader;
    compile(vertex_shader.name(), vertex);
    compile(fragment_shader.name(), fragment);
    GlProgram program;
    glAttachShader(program.name(), vertex_shader.name());
    glAttachShader(program.name(), fragment_shader.name());
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex_shader.name());
    glDetachShader(program.name(), fragment_shader.name());
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good) return program;
    std::string words(1024, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program.name(), static_cast<GLsizei>(words.size()), &length, words.data());
    words.resize(static_cast<std::size_t>(length));
    throw WorkError("the OpenGL driver cannot link a program: " + words);
}

}  // namespace sightline
