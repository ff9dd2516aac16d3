// What the colours, lines and numbers of pictures mean, row by row.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/solid_list.h"
#include "core/session/note.h"
#include "core/settings/settings.h"

namespace sightline {

/// The rows for pictures that stand beside each other or follow each other: what some of them shows inside its world,
/// in a fixed order, and the callouts among the notes. Takes time in proportion to the shapes.
std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, const Settings& settings,
                                   std::span<const Note<2>> notes);
/// The same in three dimensions; `solids` are what lies under the lists.
std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, std::span<const SolidList* const> solids,
                                   const Settings& settings, std::span<const Note<3>> notes);

}  // namespace sightline
