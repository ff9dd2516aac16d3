// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/scene_mesh.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "shell/gl/face_normal.h"

namespace sightline {

namespace {

constexpr std::size_t triangles_at_once = 1 << 16;  // no second copy of a large scene on the way

struct Corner {
    float x, y, z;
};

void check_room(std::size_t triangles) {
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw WorkError("the graphics card has no room for " + std::to_string(triangles) + " triangles");
}

/// Fills the bound array buffer; add(t, all) appends what the three corners of triangle t have.
template <typename T, typename Add>
void upload_each(std::size_t triangles, const Add& add) {
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles * 3 * sizeof(T)), nullptr, GL_STATIC_DRAW);
    // By way of another buffer: a driver takes many updates of static data for a mistake, and says so.
    const GlBuffer way;
    glBindBuffer(GL_COPY_READ_BUFFER, way.name());
    std::vector<T> part;
    part.reserve(std::min(triangles, triangles_at_once) * 3);
    for (std::size_t first = 0; first < triangles; first += triangles_at_once) {
        part.clear();
        for (std::size_t t = first; t < std::min(triangles, first + triangles_at_once); ++t) add(t, part);
        const auto bytes = static_cast<GLsizeiptr>(part.size() * sizeof(T));
        glBufferData(GL_COPY_READ_BUFFER, bytes, part.data(), GL_STREAM_DRAW);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, static_cast<GLintptr>(first * 3 * sizeof(T)),
                            bytes);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

}  // namespace

void TriangleChoice::set(std::span<const std::uint32_t> triangles) {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(triangles.size() * 3);
    for (const std::uint32_t t : triangles) vertices.insert(vertices.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    glBindVertexArray(0);  // the binding of indices belongs to a vertex array
    glBindBuffer(GL_ARRAY_BUFFER, indices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(std::uint32_t)), vertices.data(),
                 GL_DYNAMIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    check_room(triangles.size());
    count_ = triangles.size();
}

SceneMesh::SceneMesh(const Scene<3>& scene) : triangles_(scene.primitives.size()) {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
    upload_each<Corner>(triangles_, [&](std::size_t t, std::vector<Corner>& all) {
        for (const Vec<3>& p : scene.primitives[t])
            all.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    });
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    check_room(triangles_);
}

void SceneMesh::add_normals(const Scene<3>& scene) {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, normals_.name());
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_BYTE, GL_TRUE, sizeof(FaceNormal), nullptr);
    upload_each<FaceNormal>(triangles_, [&](std::size_t t, std::vector<FaceNormal>& all) {
        all.insert(all.end(), 3, normal_of(scene.primitives[t]));
    });
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    check_room(triangles_);
}

void SceneMesh::draw_all() const {
    glBindVertexArray(layout_.name());
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_ * 3));
    glBindVertexArray(0);
}

void SceneMesh::draw(const TriangleChoice& choice, std::size_t first, std::size_t count) const {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, choice.indices_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count * 3), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * 3 * sizeof(std::uint32_t)));
    glBindVertexArray(0);
}

}  // namespace sightline
