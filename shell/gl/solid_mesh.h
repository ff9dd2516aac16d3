// The faces and edges of a solid list as triangles for the graphics card, as plain data. Edges carry their widths in
// points and faces no light, so that a moving camera needs no new mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/draw/solid_list.h"
#include "shell/gl/face_normal.h"

namespace sightline {

/// A corner of a face, the same in all but its place for all corners. 24 bytes.
struct SolidVertex {
    float x = 0, y = 0, z = 0;
    FaceNormal normal;
    Colour colour = transparent;
    std::uint8_t lit = 1, sliced = 0;  ///< sliced: the list's slice cuts it
    std::uint16_t unused = 0;
};
static_assert(sizeof(SolidVertex) == 24);

/// A corner of the quad that an edge becomes. 32 bytes.
struct EdgeVertex {
    float from_x = 0, from_y = 0, from_z = 0, to_x = 0, to_y = 0, to_z = 0;
    Colour colour = transparent;
    std::uint16_t half_width = 0;  ///< in 1/edge_units_per_pt
    std::uint8_t corner = 0;       ///< +1 at its end, +2 on its left
    std::uint8_t unused = 0;
};
static_assert(sizeof(EdgeVertex) == 32);

inline constexpr double edge_units_per_pt = 64;

struct SolidMesh {
    /// Indices of a translucent face, to be drawn after what lies behind it.
    struct Sheet {
        std::array<float, 3> centre{};
        std::uint32_t first = 0, count = 0;
    };
    std::vector<SolidVertex> vertices;
    std::vector<std::uint32_t> opaque;       ///< three for a triangle
    std::vector<std::uint32_t> translucent;  ///< by sheets
    std::vector<Sheet> sheets;
    std::vector<EdgeVertex> edges;            ///< four for an edge
    std::vector<std::uint32_t> edge_indices;  ///< six for an edge
    std::vector<std::uint32_t> line_indices;  ///< two for an edge, of its corners 0 and 1
    double widest_pt = 0;                     ///< of the edges
    Box<3> bounds;                            ///< of all that is here
};

/// Replaces the mesh by the list's faces and edges. What names a style or points that there are not, has a coordinate
/// beyond 1e30 or a colour with a = 0 is left out. Edges are at least 0.5 pt wide, as lines in figures. Linear.
void make_mesh(const SolidList& list, SolidMesh& mesh);

/// Appends a triangle of the scene, for translucent ones, which have to be sorted among the faces.
void add_triangle(SolidMesh& mesh, const Primitive<3>& triangle, const SolidStyle& style);

}  // namespace sightline
