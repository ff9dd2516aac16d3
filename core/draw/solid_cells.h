// Cells as faces and edges: closed opaque bodies, glass, or wire.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/draw/solid_list.h"
#include "core/session/settings.h"
#include "core/space/cell_complex.h"

namespace sightline {

inline constexpr std::uint8_t no_style = 0xff;

/// How one cell is drawn.
struct CellPaint {
    DrawnAs as = DrawnAs::off;
    std::uint8_t group = 0;          ///< cells of one group are drawn alike and look like one body
    std::uint8_t style = 0;          ///< of its faces; of its edges when it is wire
    std::uint8_t border = no_style;  ///< of the edges of its faces; no_style: none
};

/// Adds all cells to the list; `paint` has one entry per cell. At shrink = 1 a facet is a face where the cells on its
/// sides are of different groups or only one of them has faces, and it is one face: that of the solid cell, else of the
/// lower group; cells without faces (off, wireframe) leave it to the other side. An edge between two corners is drawn
/// once, as wire before border. At 0 < shrink < 1 each cell is a body of its own about its centre.
/// Cells are tetrahedra or boxes with their corners in the order of tree_cells.
void add_cells(const CellComplex<3>& cells, std::span<const CellPaint> paint, double shrink, SolidList& list);

/// Adds wire about the marked cells: each edge, once, of a facet between a marked cell and one that is not. At
/// 0 < shrink < 1 all edges of each.
void add_outline(const CellComplex<3>& cells, std::span<const std::uint8_t> marked, std::uint8_t style, double shrink,
                 SolidList& list);

/// Adds boxes, each a body of its own that belongs to no cell; `paint` has one entry per box.
void add_boxes(std::span<const Box<3>> boxes, std::span<const CellPaint> paint, SolidList& list);

/// The edges of a box: pairs of corners as Box::corner numbers them.
std::span<const std::array<std::uint8_t, 2>> edges_of_boxes();

/// The edges of a cell: pairs of places in its row of corners.
std::span<const std::array<std::uint8_t, 2>> edges_of(const CellComplex<3>& cells, std::uint32_t cell);

/// `p` of a cell's surface drawn at this share of its size.
inline Vec<3> shrunk(const CellComplex<3>& cells, std::uint32_t cell, const Vec<3>& p, double shrink) {
    return shrink == 1 ? p : cells.centre(cell) + (p - cells.centre(cell)) * shrink;
}

}  // namespace sightline
