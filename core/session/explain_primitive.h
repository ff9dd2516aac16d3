// Where a primitive is, whether it is seen and what hides it, and when the run renders it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"
#include "core/truth/sight.h"

namespace sightline {

struct PrimitiveExplanation {
    std::uint32_t primitive = none;
    bool visible = false;
    bool culled = false;       ///< met, but outside the view: not rendered
    std::uint32_t met_at = 0;  ///< the recorded step, done or to come, that meets it; 0: none does
    /// Those that hold it, at the session's position: projected ones by their step, then those in the front, first to
    /// last, then the others by id.
    std::vector<std::uint32_t> cells;
    PrimitiveSight sight;
};

/// Cost: steps + primitives + references; 2D: O(n log n) for what hides it.
template <int D>
PrimitiveExplanation explain_primitive(const Session<D>& session, std::uint32_t primitive);

/// How it is seen: "Segment 12 is hidden by segments 7 (60 %) and 9 (40 %)."
template <int D>
std::string sight_sentence(const Session<D>& session, const PrimitiveExplanation& e);

/// When the recorded run meets it: "Step 7 will render it."
std::string met_sentence(const PrimitiveExplanation& e, std::uint32_t position);

/// Why no recorded step renders it: the verdict of the cell that comes first of those that hold it. Empty where a step
/// does, or where the method orders no cells. Cost: as explain_cell.
template <int D>
std::string put_off_sentence(const Session<D>& session, const PrimitiveExplanation& e);

/// All of these, and a line for each of the first few of its cells.
template <int D>
std::vector<std::string> rows(const Session<D>& session, const PrimitiveExplanation& e);

/// "in the front, number 3", … of a cell at the session's position, and how many of those that hold a primitive are
/// told one by one.
template <int D>
std::string place_words(const Session<D>& session, std::uint32_t cell);
inline constexpr std::size_t most_cells_told = 5;

}  // namespace sightline
