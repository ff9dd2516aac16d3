// How evenly primitives are spread over cells: TVCG 3 asks for roughly the same number in each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

/// Of |c|, the number of primitives in cell c. All but `empty` and `histogram` are over the cells that hold any; NaN
/// where none does.
struct Density {
    double empty = 0;      ///< share of the cells that hold nothing
    double mean = 0;       ///< |c|
    double deviation = 0;  ///< standard deviation over the mean: 0 is uniform
    double median = 0;     ///< |c|
    /// Cells by |c|: [0] holds those with none, [i] those with 2^(i - 1) to 2^i - 1. As long as the fullest cell needs.
    std::vector<std::uint32_t> histogram;
};

template <int D>
Density density(const CellComplex<D>& cells);

}  // namespace sightline
