// Boxes, cells and polygons as an image may see them, widened for hidden-tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/raster/image_triangles.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// How far hidden-tests are widened, in pixels: farther than corners move when they are rounded and snapped. Depths are
/// widened by a step of a float.
constexpr double query_margin = 1.0 / 128;

/// A convex polygon in the image. Whatever lies on its far side or in it, drawn by draw_depth, covers no pixel beyond
/// these, and is nowhere nearer.
struct SeenFace {
    /// a x + b y + c >= 0 in column x, row y where that pixel is not beyond the edge.
    struct Edge {
        double a, b, c;
    };
    std::vector<Edge> edges;
    int left = 0, top = 0, right = 0, bottom = 0;           ///< pixels [left, right) x [top, bottom), cut to the image
    double nearness_0 = 0, nearness_x = 0, nearness_y = 0;  ///< as of DepthImage: linear in column and row
    double nearest = 0;                                     ///< and at most this

    bool holds(int x, int y) const {
        for (const Edge& e : edges)
            if (e.a * x + e.b * y + e.c < 0) return false;
        return x >= left && x < right && y >= top && y < bottom;
    }
    double nearness(int x, int y) const { return std::min(nearest, nearness_0 + nearness_x * x + nearness_y * y); }
    /// Whether none of the pixels [x, end_x) x [y, end_y) is in it, as far as one edge tells.
    bool misses(int x, int y, int end_x, int end_y) const;
    /// No pixel of those has it nearer.
    double nearness(int x, int y, int end_x, int end_y) const;
};

/// Its faces that turn to the eye. Everywhere: the eye lies in it or so close that it may hide nothing less than the
/// whole image, as near as can be.
struct SeenShape {
    std::vector<SeenFace> faces;
    bool everywhere = false;
};

SeenShape seen_box(const View<3>& view, const ImageSize& size, const Box<3>& box);
SeenShape seen_cell(const View<3>& view, const ImageSize& size, const CellComplex<3>& cells, std::uint32_t cell);
/// Planar and convex, its corners in either order; nothing where it is seen edge-on.
SeenShape seen_polygon(const View<3>& view, const ImageSize& size, std::span<const Vec<3>> corners);

}  // namespace sightline
