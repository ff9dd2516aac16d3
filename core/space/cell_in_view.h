// Whether a cell meets the view cone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/view.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// 2D: exact. 3D: conservative (never false when it does).
bool cell_in_view(const CellComplex<2>& cells, const View<2>& view, std::uint32_t cell);
bool cell_in_view(const CellComplex<3>& cells, const View<3>& view, std::uint32_t cell);

}  // namespace sightline
