// What must hold for the cells of any tessellation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "core/space/cell_complex.h"

namespace sightline::test {

/// Exact.
template <int D>
bool holds(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& p) {
    for (const HalfFacet& half : cells.facets_of(cell))
        if (facet_side(cells, half, p) < 0) return false;
    return true;
}

template <int D>
std::uint32_t lowest_holding(const CellComplex<D>& cells, const Vec<D>& p) {
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        if (holds(cells, cell, p)) return cell;
    return none;
}

/// Neighbours know each other, with opposite sides of one facet, and lie on those sides of it. sliver(cells, cell):
/// cells whose rounded centre may lie outside them.
template <int D, typename Sliver>
void expect_linked(const CellComplex<D>& cells, Sliver sliver) {
    std::vector<std::uint32_t> border;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            if (!sliver(cells, cell)) {
                ASSERT_GT(facet_side(cells, half, cells.centre(cell)), 0);
            }
            if (half.neighbour == none) {
                if (border.empty() || border.back() != cell) border.push_back(cell);
                continue;
            }
            if (!sliver(cells, half.neighbour)) {
                ASSERT_LT(facet_side(cells, half, cells.centre(half.neighbour)), 0);
            }
            int back = 0;
            for (const HalfFacet& other : cells.facets_of(half.neighbour))
                back += other.neighbour == cell && other.facet() == half.facet() && other.flipped() != half.flipped();
            ASSERT_EQ(back, 1);
        }
    ASSERT_EQ(cells.border_cells, border);
}

}  // namespace sightline::test
