// Where everything of a figure goes on its page: plain rectangles and text runs in points, y down from the top left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/draw/draw_list.h"
#include "shell/figure/font.h"
#include "shell/figure/page.h"

namespace sightline {

struct Layout {
    struct Panel {
        Rect frame;
        Box<2> world;    ///< what the frame shows: the list's world, widened where that has no area
        Rect title_box;  ///< zero when there is no title
        std::vector<TextRun> title;
    };
    struct Row {
        Rect box, swatch;
        std::vector<TextRun> text;
    };
    struct Bar {
        Rect box, strip;
        std::vector<TextRun> text;  ///< title, low, high
    };
    double width = 0, height = 0;  ///< of the page
    double font_pt = 8;            ///< as asked, or smaller when a small pixel size leaves no room
    double scale = 1;              ///< points per scene unit, the same in each panel
    std::vector<Panel> panels;
    std::optional<Rect> legend_box;  ///< when the legend stands inside a panel: its background
    std::vector<Row> legend;
    std::optional<Bar> bar;
    Rect caption_box;
    std::vector<TextRun> caption;
};

/// Lines and marks grow with the text: what a width or size in points is multiplied with. The widths of styles are
/// those of a figure with text of 8 points.
inline double line_scale(const Layout& layout) { return layout.font_pt / 8; }

/// A scene point on the page. Finite for finite points whose distance to the world is not absurd.
inline Vec<2> to_page(const Layout::Panel& panel, double scale, const Vec<2>& p) {
    return {panel.frame.x + (p.x - panel.world.min.x) * scale,
            panel.frame.bottom() - (p.y - panel.world.min.y) * scale};
}

/// The list's own world on the page: the frame, or the part of it that the world fills where the frame shows more.
inline Rect world_on_page(const DrawList& list, const Layout::Panel& panel, double scale) {
    const Vec<2> extent = list.world.extent();
    if (!(extent.x > 0 && extent.y > 0 && is_finite<2>(list.world.min) && is_finite<2>(list.world.max)))
        return panel.frame;
    const Vec<2> low = to_page(panel, scale, list.world.min), high = to_page(panel, scale, list.world.max);
    return {low.x, high.y, high.x - low.x, low.y - high.y};
}

}  // namespace sightline
