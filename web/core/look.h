// What a page reads of its bench: small things, as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "web/core/page.h"

namespace sightline {

/// Scene, where the run stands, what was said, the desk, the lesson, and the rows of the panel at the right.
std::string look_json(Page& page);

/// Rows of any panel. Throws InputError for a panel that does not exist.
std::string panel_json(Page& page, const std::string& id);

/// The settings, a row each, with their values.
std::string settings_json(Page& page);

/// What stays while a dimension stays: commands with their keys, menus, panels, methods, presets.
std::string tables_json(Page& page);

/// Scenes of both dimensions, levels and lessons, as a list to choose from.
std::string scenes_json();

/// The curve of the run: coverage and the best possible per step, the cell of each, marks.
std::string curve_json(Page& page);

/// The trade-off's chart: its axes, and a dot for each method and budget that is measured.
std::string trade_off_json(Page& page);

/// The lines that a term of a key lights up in the picture.
std::string light_json(Page& page, int about, std::uint32_t from, std::uint32_t facet, std::uint32_t cell);

/// The corners of a cell in the plane.
std::string corners_json(Page& page, std::uint32_t cell);

}  // namespace sightline
