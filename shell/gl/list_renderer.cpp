// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/list_renderer.h"

#include <cmath>
#include <cstddef>

#include "shell/gl/list_shader.h"

namespace sightline {

namespace {

/// As in figures of 8 pt text.
constexpr double hatch_pitch_pt = 3.2, hatch_width_pt = 0.5;

/// One input of the vertex shader.
void describe(GLuint location, GLint size, GLenum type, GLboolean normalised, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, type, normalised, sizeof(MeshVertex), reinterpret_cast<const void*>(offset));
}

template <typename T>
void upload(GLenum target, const std::vector<T>& data) {
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

}  // namespace

ListRenderer::Program ListRenderer::make(MeshRun::Kind kind) {
    GlProgram program = make_program(list_vertex_shader(kind), list_fragment_shader(kind));
    const auto at = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
    const GLint scale = at("scale"), shift = at("shift"), half_view = at("half_view"), pt = at("pt"),
                hatch = at("hatch"), anchor = at("anchor");
    return {std::move(program), scale, shift, half_view, pt, hatch, anchor};
}

ListRenderer::ListRenderer()
    : programs_{make(MeshRun::Kind::fills), make(MeshRun::Kind::lines), make(MeshRun::Kind::mixed)} {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    describe(0, 2, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, x));
    describe(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(MeshVertex, colour));
    describe(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(MeshVertex, second));
    describe(3, 2, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, length));
    describe(4, 2, GL_UNSIGNED_SHORT, GL_FALSE, offsetof(MeshVertex, half_width));
    describe(5, 2, GL_BYTE, GL_FALSE, offsetof(MeshVertex, dx));
    describe(6, 2, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(MeshVertex, paint));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void ListRenderer::set(const DrawList& list) {
    make_mesh(list, mesh_);
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    upload(GL_ARRAY_BUFFER, mesh_.vertices);
    upload(GL_ELEMENT_ARRAY_BUFFER, mesh_.indices);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void ListRenderer::draw(const ListView& view) const {
    const Vec<2> extent = view.world.extent();
    if (view.w <= 0 || view.h <= 0 || !(extent.x > 0 && extent.y > 0)) return;
    glViewport(view.x, view.y, view.w, view.h);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);  // triangles are clipped to the viewport anyway
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(layout_.name());

    // In double, so that floats carry only what is left after the shift: pixels within the view.
    const double scale = view.w / extent.x;
    const Vec<2> shift = (mesh_.origin - view.world.min) * scale;
    const double pitch = hatch_pitch_pt * view.px_per_pt;
    // Hatches stay with the scene; far from its middle they jump once in thousands of pitches, or floats would not do.
    const double period = 4096 * pitch;
    const Vec<2> anchor(std::remainder(shift.x, period) + view.x, std::remainder(shift.y, period) + view.y);
    for (const MeshRun& run : mesh_.runs) {
        const Program& p = programs_[static_cast<std::size_t>(run.kind)];
        glUseProgram(p.program.name());
        glUniform1f(p.scale, static_cast<float>(scale));
        glUniform2f(p.shift, static_cast<float>(shift.x), static_cast<float>(shift.y));
        glUniform2f(p.half_view, static_cast<float>(view.w / 2.0), static_cast<float>(view.h / 2.0));
        glUniform1f(p.pt, static_cast<float>(view.px_per_pt * view.line_scale));
        glUniform2f(p.hatch, static_cast<float>(pitch), static_cast<float>(hatch_width_pt / 2 * view.px_per_pt));
        glUniform2f(p.anchor, static_cast<float>(anchor.x), static_cast<float>(anchor.y));
        if (run.opaque)
            glDisable(GL_BLEND);
        else
            glEnable(GL_BLEND);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(std::size_t{run.first} * sizeof(std::uint32_t)));
    }
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
}

}  // namespace sightline
