// Primitives that no cell holds whole: where the tessellation ends before them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/space/cell_complex.h"

namespace sightline {

/// Those that reach beyond the border of the tessellation, or lie wholly beyond it; ascending. Exact, but for a
/// triangle that a row cell -> primitives holds by a rounding error. The tessellation is convex: what crosses its
/// border lies in a cell at the border, with a corner on the far side of one of that cell's facets there.
template <int D>
std::vector<std::uint32_t> reaching_outside(const CellComplex<D>& cells, const std::vector<Primitive<D>>& primitives);

}  // namespace sightline
