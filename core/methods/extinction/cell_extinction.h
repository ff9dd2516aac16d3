// How much of the light that crosses a cell its primitives take, from their area and the cell's own surface alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/run/problem.h"

namespace sightline {

/// Of each cell; neither changes with the unit of length.
template <int D>
struct CellExtinction {
    /// Optical depth of the cell along its mean chord if its primitives lay in it in all directions alike: twice their
    /// area inside the cell (2D: length) over the cell's surface (2D: border). A line that crosses the cell meets so
    /// many of them in the mean (Cauchy, Crofton). 0 for a cell without a surface.
    std::vector<double> depth;
    /// Mean length of such a line inside the cell: 4 volume / surface (2D: π area / border), scene units.
    std::vector<double> chord;
};

/// Made when it is first asked for and kept with the cells; the threads it is made on decide nothing.
template <int D>
std::shared_ptr<const CellExtinction<D>> cell_extinction(const Problem<D>& problem);

/// Length of the part of the segment that lies in the cell, rounded.
template <int D>
double length_in_cell(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& from, const Vec<D>& to);

/// Area of the triangle, or length of the segment, inside the cell, rounded.
template <int D>
double size_in_cell(const CellComplex<D>& cells, std::uint32_t cell, const Primitive<D>& primitive);

}  // namespace sightline
