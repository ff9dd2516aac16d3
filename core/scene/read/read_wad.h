// Doom WAD files (IWAD and PWAD, maps in Doom's own format): walls become segments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

struct WadOptions {
    std::string map;         ///< "E1M2", any case; empty: the first map of the file
    bool two_sided = false;  ///< also lines that one can see through (a second side): steps, windows, door frames
};

/// Names of the maps in the file's order: every lump followed by THINGS, LINEDEFS, SIDEDEFS and VERTEXES.
/// Throws InputError when the bytes are no WAD or its directory does not fit them.
std::vector<std::string> wad_maps(std::string_view bytes, const std::string& name);

/// Coordinates are map units, not recentred. The start view is that of player 1 (the last thing of type 1), 90 degrees
/// wide; default_view() where there is none. Of maps of one name the last counts. Objects are the sectors, a line being
/// of that on its right side. The id is "name#MAP". Throws InputError "name: LINEDEFS record 12: reason"; an
/// unknown map's line lists the known ones.
Scene<2> read_wad(std::string_view bytes, const std::string& name, const WadOptions& options = {});

}  // namespace sightline
