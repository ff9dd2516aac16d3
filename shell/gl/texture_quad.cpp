// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/texture_quad.h"

#include "shell/gl/program.h"

namespace sightline {

namespace {

// One triangle that covers the viewport.
constexpr const char* quad_vertex_shader = R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

// Pixel by pixel: a software renderer takes far longer for filtered samples.
constexpr const char* quad_fragment_shader = R"(#version 330 core
uniform sampler2D picture;
uniform ivec2 corner;
uniform float opacity;
out vec4 result;
void main() { result = texelFetch(picture, ivec2(gl_FragCoord.xy) - corner, 0) * opacity; }
)";

}  // namespace

TextureQuad::TextureQuad()
    : program_(make_program(quad_vertex_shader, quad_fragment_shader)),
      corner_(glGetUniformLocation(program_.name(), "corner")),
      opacity_(glGetUniformLocation(program_.name(), "opacity")) {}

void TextureQuad::draw(GLuint texture, int x, int y, int w, int h, bool blended, float opacity) const {
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
    glUniform2i(corner_, x, y);
    glUniform1f(opacity_, opacity);
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
