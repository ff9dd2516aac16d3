// What is really visible, per primitive and per cell: the yardstick of every metric.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/measure/visible_set.h"
#include "core/space/cell_complex.h"

namespace sightline {

struct Reference {
    std::string name;                   ///< "exact" or "item buffer W"
    std::vector<std::uint8_t> visible;  ///< per primitive
    std::size_t count = 0;              ///< |V|
    /// Per cell: the part of the visible angle (2D) or pixels (3D) that lies inside it; 0: hidden. A piece on the
    /// border of two cells counts in both.
    std::vector<double> cell_share;
    std::size_t eye_on = 0;  ///< primitives that contain the eye (visible_set.h)
    std::vector<VisiblePiece> pieces;
};

/// The exact reference in 2D.
Reference exact_reference(const std::vector<Primitive<2>>& primitives, const CellComplex<2>& cells,
                          const View<2>& view);

}  // namespace sightline
