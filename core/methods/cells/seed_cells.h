// Where a traversal of cells starts (TVCG 4.2, findCell).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_parameters.h"
#include "core/run/problem.h"

namespace sightline {

/// The cell that holds the eye, else the nearest of those in view, else the nearest. With seeds = hull and the eye
/// outside: every border cell in view with a facet towards the eye, nearest first. Empty when there are no cells.
template <int D>
std::vector<std::uint32_t> seed_cells(const Problem<D>& problem, Seeds wanted);
/// As the problem's parameters say.
template <int D>
std::vector<std::uint32_t> seed_cells(const Problem<D>& problem) {
    return seed_cells(problem, problem.parameters.template choice<Seeds>(seeds_row()));
}

}  // namespace sightline
