// What the picture says of a cell: its tooltip, and where it stands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shell/desk/workbench.h"
#include "shell/window/ui.h"

namespace sightline {

/// For the tooltip.
template <int D>
std::string cell_words(const Session<D>& session, std::uint32_t cell);

/// Adds the cell's centre to the places that scripts and readers of the screen may ask for. `at` maps it into the
/// window; nothing: it is not shown.
template <int D, typename ToWindow>
void note_cell(Workbench<D>& bench, const std::string& name, std::uint32_t cell, const ToWindow& to_window) {
    const CellComplex<D>& cells = bench.session.cells();
    if (cell >= cells.cell_count()) return;
    if (const std::optional<ImVec2> at = to_window(cells.centre(cell)))
        bench.places.push_back({name, at->x, at->y, 0, 0});
}

}  // namespace sightline
