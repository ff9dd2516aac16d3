// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/texture_quad.h"

#include "shell/gl/program.h"

namespace sightline {

namespace {

// One triangle that covers the viewport.
constexpr const char* vertex_shader = R"(#version 330 core
out vec2 uv;
void main() {
    uv = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
in vec2 uv;
uniform sampler2D picture;
out vec4 result;
void main() { result = texture(picture, uv); }
)";

}  // namespace

TextureQuad::TextureQuad() : program_(make_program(vertex_shader, fragment_shader)) {}

void TextureQuad::draw(GLuint texture, int x, int y, int w, int h, bool blended) const {
    if (w <= 0 || h <= 0) return;
    glViewport(x, y, w, h);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    if (blended) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        glDisable(GL_BLEND);
    }
    glUseProgram(program_.name());  // its sampler is unit 0
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glBindVertexArray(layout_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
    glDisable(GL_BLEND);
}

}  // namespace sightline
