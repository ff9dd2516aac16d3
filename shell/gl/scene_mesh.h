// The triangles of a 3D scene on the graphics card.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/scene/scene.h"
#include "shell/gl/handles.h"

namespace sightline {

/// Which triangles of a mesh to draw, in which order. Made, used and destroyed while one OpenGL context is current.
class TriangleChoice {
public:
    /// Replaces what was chosen: ids of triangles.
    void set(std::span<const std::uint32_t> triangles);
    std::size_t count() const { return count_; }

private:
    friend class SceneMesh;
    GlBuffer indices_;
    std::size_t count_ = 0;
};

/// Three vertices a triangle, none shared, 36 bytes a triangle: attribute 0 is the corner (vec3, scene units, rounded
/// to float), gl_VertexID / 3 the triangle's id, also when a choice is drawn. Made, used and destroyed while one OpenGL
/// context is current. Drawing needs a program in use and leaves no vertex array bound.
class SceneMesh {
public:
    /// Uploads the triangles; keeps no reference. Throws WorkError when the card has no room.
    explicit SceneMesh(const Scene<3>& scene);

    /// Attribute 1 from now on: the triangle's normal (vec3, about unit length; zero for one without area), 12 bytes a
    /// triangle. `scene` is that of the constructor. Throws WorkError when the card has no room.
    void add_normals(const Scene<3>& scene);

    std::size_t triangles() const { return triangles_; }
    /// All triangles in the order of their ids.
    void draw_all() const;
    /// `count` triangles of the choice from `first` on.
    void draw(const TriangleChoice& choice, std::size_t first, std::size_t count) const;

private:
    GlVertexArray layout_;
    GlBuffer corners_, normals_;
    std::size_t triangles_ = 0;
};

}  // namespace sightline
