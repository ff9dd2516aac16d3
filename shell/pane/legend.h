// The legend in a corner of the picture, with real swatches: a small draw list of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/draw/palette.h"
#include "shell/pane/labels.h"

namespace sightline {

/// One scene unit is an ImGui unit; (0, 0) is the lower left corner, y up. list.world is all of it.
struct LegendBox {
    DrawList list;
    float w = 0, h = 0;
};

/// Rows from above, then the colour bar, on paper of the palette's background. `measure` in ImGui units, for the texts;
/// `unit` as Ui::unit, `line_scale` as the list is drawn with (ListView). Empty without rows and bar.
LegendBox make_legend(std::span<const LegendRow> rows, const std::optional<ColourBar>& bar, const Colours& colours,
                      const std::function<ImVec2(const std::string&)>& measure, float unit, double line_scale = 1);

/// The corner of the area where it hides none of the points: the lower left one, else the next that is free, going
/// round; the lower left one when none is.
Area legend_place(const LegendBox& legend, const Area& area, float margin, std::span<const ImVec2> points);

}  // namespace sightline
