// Cells that showed something in the frame before: what a run may start from besides the eye's.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/run/marks.h"
#include "core/run/problem.h"

namespace sightline {

/// What a frame leaves to the next: of the cells that it projected those of whose primitives a pixel shows one, in an
/// image of what was rendered, as large as the problem's services say. Draws that image.
template <int D>
std::shared_ptr<const FrameHistory> cells_that_show(const Problem<D>& problem, const Marks& marks,
                                                    std::span<const Met> met);

/// Those of the problem's history that meet the view, nearest first. None where there is no history, or where it is of
/// another number of cells.
template <int D>
std::vector<std::uint32_t> cells_seen_before(const Problem<D>& problem);

}  // namespace sightline
