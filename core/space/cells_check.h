// Whether cells that come from outside hang together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

/// What is wrong, in a few words, or nullptr: indices out of range, rows that do not add up, links that lead one way
/// only, a tree whose nodes are not halves of each other, coordinates that are not finite. Takes cells without
/// border_cells, ρ_max, ρ95 and unassigned.
template <int D>
const char* fault(const CellComplex<D>& cells, std::size_t primitive_count);

}  // namespace sightline
