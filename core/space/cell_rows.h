// What a traversal asks of a cell, in one place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/index.h"
#include "core/base/large_pages.h"

namespace sightline {

template <int D>
struct CellComplex;

/// One side of a facet, as a cell sees it.
struct HalfFacet {
    std::uint32_t neighbour = none;  ///< the cell on the other side; none at the border of the tessellation
    std::uint32_t facet_side = 0;    ///< facet * 2, + 1 when the facet's points turn the other way for this cell

    std::uint32_t facet() const { return facet_side >> 1; }
    bool flipped() const { return facet_side & 1; }
};

/// A tetrahedron and the corners of those behind its facets, in one cache line: whether they are in view is asked
/// before anything else is known of them. CellComplex keeps each in an array of its own.
struct alignas(64) CellRow {
    std::array<std::uint32_t, 4> corners;
    std::array<HalfFacet, 4> facets;    ///< facet i lies opposite corner i
    std::array<std::uint32_t, 4> apex;  ///< the corner of the neighbour behind facet i that is not one of it; or none
};
static_assert(sizeof(CellRow) == 64);

/// Those of all cells; none where they are no tetrahedra.
LargeVector<CellRow> cell_rows(const CellComplex<3>& cells);

}  // namespace sightline
