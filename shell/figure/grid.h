// Panels in rows and columns: the arrangement with the largest panels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "shell/figure/key.h"

namespace sightline {

struct Grid {
    double scale = 0;  ///< points per scene unit
    std::size_t columns = 0;
    double w = 0, h = 0;
    std::vector<Rect> frames;       ///< relative to the grid's top left corner
    std::vector<Rect> title_boxes;  ///< zero without a title
    std::vector<Slot> titles;
    Rect free;  ///< what the last row leaves, from the height of its frames on; zero where it is full
};

enum class GridAim : std::uint8_t {
    largest,  ///< the largest panels
    full,     ///< large panels, but empty places at the end count against an arrangement
};

/// Arranges panels of these extents (scene units, all > 0) within the room (points). titles[panel][page] are cleaned.
/// `columns` > 0 is obeyed. Nothing when the titles leave no room for the panels.
std::optional<Grid> arrange_panels(const Font& font, std::span<const Vec<2>> extents,
                                   std::span<const std::vector<std::string>> titles, double size, const Vec<2>& room,
                                   GridAim aim, std::size_t columns = 0);

}  // namespace sightline
