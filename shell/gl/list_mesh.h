// A draw list as triangles for the graphics card, as plain data. Lines and marks carry their widths in points, so that
// zooming and panning need no new mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/draw/draw_list.h"

namespace sightline {

/// What the triangles of a vertex paint; how far they reach beyond their points is the vertex shader's affair.
enum class Paint : std::uint8_t {
    fill,    ///< a triangle; with `second` as the hatch's colour where `hatch` says so
    solid,   ///< a line with round ends, `length` long in scene units; a disc is one of no length
    dashed,  ///< the same in dashes, `start` scene units after the start of its polyline
    dotted,  ///< the same in dots
    ring,    ///< a circle's outline, of radius `size`
    bar,     ///< a line of `size` points' length around its point
    head,    ///< an arrow's head of length `size` points, its tip at the point
};

/// Three for a triangle of a fill, four for the quad of anything else. 32 bytes.
struct MeshVertex {
    float x = 0, y = 0;  ///< scene units from ListMesh::origin
    Colour colour = transparent;
    Colour second = transparent;   ///< of a hatch
    float length = 0, start = 0;   ///< of a line, scene units
    std::uint16_t half_width = 0;  ///< of a line, in 1/mesh_units_per_pt
    std::uint16_t size = 0;        ///< of a mark; of a line what its end is shortened by; 1/mesh_units_per_pt
    std::int8_t dx = 0, dy = 0;    ///< the direction of a line or a head, of length 127
    Paint paint = Paint::fill;
    std::uint8_t corner = 0;  ///< of a quad: +1 at its end, +2 on its left; of a fill the Hatch
};
static_assert(sizeof(MeshVertex) == 32);

inline constexpr double mesh_units_per_pt = 64;

/// Triangles drawn by one call, one program.
struct MeshRun {
    enum class Kind : std::uint8_t {
        fills,  ///< no line among them
        lines,  ///< solid lines and discs only
        mixed,
    };
    Kind kind = Kind::mixed;
    bool opaque = false;                 ///< fills whose colours all cover what lies below
    std::uint32_t first = 0, count = 0;  ///< of ListMesh::indices
};

/// In the order of the shapes: what comes later lies on top.
struct ListMesh {
    Vec<2> origin{};  ///< scene units; the centre of what the list shows, so that floats are precise there
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three for a triangle
    std::vector<MeshRun> runs;
};

/// Widths, marks and heads as in figures (shell/figure/paint.h). Shapes that name a style or points that there are not,
/// or lie at more than 1e30 from the origin, are left out; labels are not part of a mesh. Linear in the list.
void make_mesh(const DrawList& list, ListMesh& mesh);

}  // namespace sightline
