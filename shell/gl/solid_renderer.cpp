// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/solid_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/base/error.h"
#include "shell/gl/reversed_depth.h"
#include "shell/gl/solid_shader.h"
#include "shell/gl/target.h"

namespace sightline {

namespace {

/// With 4 samples of colour and depth, 128 MiB.
constexpr int largest_tile = 2048;

void describe_attribute(GLuint location, GLint size, GLenum type, GLboolean normalised, std::size_t stride,
                        std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, type, normalised, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
}

/// Through the array binding, which belongs to no vertex array; also for indices.
template <typename T>
void upload_to(const GlBuffer& buffer, const std::vector<T>& data, GLenum use) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), use);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void draw_indices(GLenum shape, const GlBuffer& indices, std::size_t count) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    glDrawElements(shape, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

GLint place(const GlProgram& program, const char* name) { return glGetUniformLocation(program.name(), name); }

glm::vec3 floats(const Vec<3>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

void set_camera(const CameraMatrix& camera, GLint clip, GLint eye, GLint eye_rest) {
    glUniformMatrix4fv(clip, 1, GL_FALSE, &camera.clip[0][0]);
    glUniform3fv(eye, 1, &camera.eye[0]);
    glUniform3fv(eye_rest, 1, &camera.eye_rest[0]);
}

/// Stretches the part (of w x h pixels) over the whole of the image.
void choose_part(CameraMatrix& camera, int w, int h, double px, double py, double pw, double ph) {
    const double scale_x = w / pw, scale_y = h / ph;
    const double shift_x = (w - 2 * px - pw) / pw, shift_y = (h - 2 * py - ph) / ph;
    for (int i = 0; i < 4; ++i) {
        camera.clip[i][0] = static_cast<float>(scale_x * camera.clip[i][0] + shift_x * camera.clip[i][3]);
        camera.clip[i][1] = static_cast<float>(scale_y * camera.clip[i][1] + shift_y * camera.clip[i][3]);
    }
}

bool usable_camera(const CameraMatrix& camera) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(camera.clip[i / 4][i % 4])) return false;
    return true;
}

bool all_in_order(std::span<const std::uint32_t> triangles, std::size_t count) {
    if (triangles.size() != count) return false;
    for (std::size_t i = 0; i < count; ++i)
        if (triangles[i] != i) return false;
    return true;
}

}  // namespace

SolidRenderer::FaceProgram SolidRenderer::make_face_program() {
    GlProgram p = make_program(solid_face_vertex_shader, solid_face_fragment_shader);
    const GLint clip = place(p, "clip"), eye = place(p, "eye"), eye_rest = place(p, "eye_rest"),
                forward = place(p, "forward"), lamp = place(p, "lamp"), slice = place(p, "slice");
    return {std::move(p), clip, eye, eye_rest, forward, lamp, slice};
}

SolidRenderer::EdgeProgram SolidRenderer::make_edge_program(const char* vertex, const char* fragment) {
    GlProgram p = make_program(vertex, fragment);
    const GLint clip = place(p, "clip"), eye = place(p, "eye"), eye_rest = place(p, "eye_rest"),
                half_view = place(p, "half_view"), pt = place(p, "pt");
    return {std::move(p), clip, eye, eye_rest, half_view, pt};
}

SolidRenderer::SolidRenderer()
    : face_program_(make_face_program()),
      edge_program_(make_edge_program(solid_edge_vertex_shader, solid_edge_fragment_shader)),
      line_program_(make_edge_program(solid_line_vertex_shader, solid_face_fragment_shader)) {
    constexpr std::size_t face = sizeof(SolidVertex), edge = sizeof(EdgeVertex);
    glBindVertexArray(face_layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    describe_attribute(0, 3, GL_FLOAT, GL_FALSE, face, offsetof(SolidVertex, x));
    describe_attribute(1, 3, GL_BYTE, GL_TRUE, face, offsetof(SolidVertex, normal));
    describe_attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, face, offsetof(SolidVertex, colour));
    describe_attribute(3, 2, GL_UNSIGNED_BYTE, GL_FALSE, face, offsetof(SolidVertex, lit));
    glBindVertexArray(edge_layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, edges_.name());
    describe_attribute(0, 3, GL_FLOAT, GL_FALSE, edge, offsetof(EdgeVertex, from_x));
    describe_attribute(1, 3, GL_FLOAT, GL_FALSE, edge, offsetof(EdgeVertex, to_x));
    describe_attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, edge, offsetof(EdgeVertex, colour));
    describe_attribute(3, 1, GL_UNSIGNED_SHORT, GL_FALSE, edge, offsetof(EdgeVertex, half_width));
    describe_attribute(4, 1, GL_UNSIGNED_BYTE, GL_FALSE, edge, offsetof(EdgeVertex, corner));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void SolidRenderer::upload_faces() {
    upload_to(vertices_, mesh_.vertices, GL_STATIC_DRAW);
    sorted_for_.reset();
}

void SolidRenderer::set(const SolidList& list) {
    styles_ = list.styles;
    background_ = list.background;
    slice_ = list.slice;
    if (scene_ != list.scene) {
        scene_ = list.scene;
        scene_mesh_.reset();
        scene_bounds_ = scene_ ? bounds<3>(scene_->primitives) : Box<3>{};
    }
    make_mesh(list, mesh_);
    list_vertices_ = mesh_.vertices.size();
    list_sheets_ = mesh_.sheets.size();
    list_translucent_ = mesh_.translucent.size();
    upload_faces();
    upload_to(opaque_, mesh_.opaque, GL_STATIC_DRAW);
    upload_to(edges_, mesh_.edges, GL_STATIC_DRAW);
    upload_to(edge_indices_, mesh_.edge_indices, GL_STATIC_DRAW);
    upload_to(line_indices_, mesh_.line_indices, GL_STATIC_DRAW);
    set_triangles(list.runs, list.triangles);
}

void SolidRenderer::set_triangles(std::span<const SolidList::Run> runs, std::span<const std::uint32_t> triangles) {
    const bool had_sheets = mesh_.sheets.size() > list_sheets_;
    mesh_.vertices.resize(list_vertices_);
    mesh_.sheets.resize(list_sheets_);
    mesh_.translucent.resize(list_translucent_);
    ranges_.clear();
    const std::size_t in_scene = scene_ ? scene_->primitives.size() : 0;
    const auto exists = [&](std::uint32_t t) { return t < in_scene; };
    bool choose = false;
    for (const SolidList::Run& run : runs) {
        if (run.style >= styles_.size() || std::size_t{run.first} + run.count > triangles.size()) continue;
        const SolidStyle& style = styles_[run.style];
        const auto ids = triangles.subspan(run.first, run.count);
        if (ids.empty() || style.colour.a == 0 || !std::all_of(ids.begin(), ids.end(), exists)) continue;
        if (style.colour.a < 255) {
            for (const std::uint32_t t : ids) add_triangle(mesh_, scene_->primitives[t], style);
            continue;
        }
        ranges_.push_back({style, run.first, run.count, all_in_order(ids, in_scene)});
        choose |= !ranges_.back().all;
    }
    if (had_sheets || mesh_.sheets.size() > list_sheets_) upload_faces();
    if (!ranges_.empty() && !scene_mesh_) {
        scene_mesh_.emplace(*scene_);
        scene_mesh_->add_normals(*scene_);
    }
    if (choose) choice_.set(triangles);
}

void SolidRenderer::sort_sheets(const Vec<3>& eye) {
    if (sorted_for_ == eye) return;
    const glm::vec3 at = floats(eye);
    std::vector<std::pair<float, std::uint32_t>> order(mesh_.sheets.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const auto& c = mesh_.sheets[i].centre;
        const glm::vec3 d = glm::vec3(c[0], c[1], c[2]) - at;
        order[i] = {-glm::dot(d, d), i};
    }
    std::sort(order.begin(), order.end());
    sorted_.clear();
    for (const auto& [distance, i] : order) {
        const SolidMesh::Sheet& sheet = mesh_.sheets[i];
        const auto first = mesh_.translucent.begin() + sheet.first;
        sorted_.insert(sorted_.end(), first, first + sheet.count);
    }
    upload_to(translucent_, sorted_, GL_STREAM_DRAW);
    sorted_for_ = eye;
}

void SolidRenderer::draw_faces(const CameraMatrix& camera, const Vec<3>& forward) {
    // From above and one corner: the four walls of a box differ.
    const int up = scene_ ? scene_->up_axis : 2;
    const Vec<3> lamp = up == 0   ? Vec<3>(0.85, 0.5, 0.17)
                        : up == 1 ? Vec<3>(0.17, 0.85, 0.5)
                                  : Vec<3>(0.17, -0.5, 0.85);
    glUseProgram(face_program_.program.name());
    set_camera(camera, face_program_.clip, face_program_.eye, face_program_.eye_rest);
    const glm::vec3 way = floats(forward), light = floats(lamp / std::sqrt(glm::dot(lamp, lamp)));
    glUniform3fv(face_program_.forward, 1, &way[0]);
    glUniform3fv(face_program_.lamp, 1, &light[0]);
    // Mesa 22 goes on cutting after it was told to stop, so that without a slice the plane must cut nothing.
    const Slice slice = slice_.value_or(Slice{Vec<3>(0), 1});
    const glm::vec3 normal = floats(slice.normal);
    glUniform4f(face_program_.slice, normal.x, normal.y, normal.z, static_cast<float>(slice.offset));
    if (slice_) glEnable(GL_CLIP_DISTANCE0);
    for (const Range& range : ranges_) {
        const Colour& c = range.style.colour;
        glVertexAttrib4Nub(2, c.r, c.g, c.b, c.a);
        glVertexAttrib2f(3, range.style.lit, 1);
        if (range.all)
            scene_mesh_->draw_all();
        else
            scene_mesh_->draw(choice_, range.first, range.count);
    }
    glBindVertexArray(face_layout_.name());
    if (!mesh_.opaque.empty()) draw_indices(GL_TRIANGLES, opaque_, mesh_.opaque.size());
    if (!sorted_.empty()) {
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);
        draw_indices(GL_TRIANGLES, translucent_, sorted_.size());
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }
    glDisable(GL_CLIP_DISTANCE0);
}

void SolidRenderer::draw_edges(const CameraMatrix& camera, int w, int h, double px_per_pt, bool quick) const {
    const EdgeProgram& program = quick ? line_program_ : edge_program_;
    glUseProgram(program.program.name());
    set_camera(camera, program.clip, program.eye, program.eye_rest);
    glUniform2f(program.half_view, static_cast<float>(w / 2.0), static_cast<float>(h / 2.0));
    glUniform1f(program.pt, static_cast<float>(px_per_pt));
    glBindVertexArray(edge_layout_.name());
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    if (quick)
        draw_indices(GL_LINES, line_indices_, mesh_.line_indices.size());
    else
        draw_indices(GL_TRIANGLES, edge_indices_, mesh_.edge_indices.size());
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void SolidRenderer::draw_part(const View<3>& view, int w, int h, const Part& part, int x, int y, double px_per_pt,
                              bool quick) {
    glViewport(x, y, part.w, part.h);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    const ReversedDepth depth;
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, part.w, part.h);
    glClearColor(background_.r / 255.0f, background_.g / 255.0f, background_.b / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);  // triangles are clipped to the viewport anyway

    Box<3> all = mesh_.bounds;
    if (!scene_bounds_.empty()) {
        all.add(scene_bounds_.min);
        all.add(scene_bounds_.max);
    }
    CameraMatrix camera = camera_matrix(view, all, depth.zero_to_one());
    choose_part(camera, w, h, part.x, part.y, part.w, part.h);
    if (all.empty() || !usable_camera(camera)) return;
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    sort_sheets(view.eye);
    if (!mesh_.edge_indices.empty()) {
        // An edge lies on its faces and its quad reaches half its width beside it: faces step back by the depth that
        // they gain over that distance, and by what rounding may do.
        const double reach = mesh_.widest_pt / 2 * px_per_pt + 0.5;
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(static_cast<float>(-1.5 * reach), -16);
    }
    draw_faces(camera, view.forward());
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!mesh_.edge_indices.empty()) draw_edges(camera, part.w, part.h, px_per_pt, quick);
    glBindVertexArray(0);
    glUseProgram(0);
}

void SolidRenderer::draw(const View<3>& camera, int x, int y, int w, int h, double px_per_pt, bool quick) {
    if (w > 0 && h > 0) draw_part(camera, w, h, {0, 0, w, h}, x, y, px_per_pt, quick);
}

Pixels SolidRenderer::picture(const SolidList& list, int width, int height, double px_per_pt) {
    if (std::max(width, height) > largest_solid_picture)
        throw WorkError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels: a solid is drawn with at most " + std::to_string(largest_solid_picture) + " a side");
    Pixels pixels{std::max(width, 0), std::max(height, 0), {}};
    if (width <= 0 || height <= 0) return pixels;
    set(list);
    GLint most = 0, most_viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most_viewport);
    const int side = std::min({largest_tile, most, most_viewport[0], most_viewport[1]});
    const GlTarget target(std::min(width, side), std::min(height, side), 4, true);
    pixels.colours.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side) {
            const Part part{x, y, std::min(side, width - x), std::min(side, height - y)};
            target.bind();
            draw_part(list.camera, width, height, part, 0, 0, px_per_pt, false);
            const Pixels tile = target.read();
            for (int row = 0; row < part.h; ++row) {
                const auto from =
                    tile.colours.begin() + static_cast<std::ptrdiff_t>(target.height() - 1 - row) * target.width();
                std::copy(from, from + part.w,
                          pixels.colours.begin() + static_cast<std::ptrdiff_t>(height - 1 - y - row) * width + x);
            }
        }
    return pixels;
}

}  // namespace sightline
