// What stands over a pane's picture: labels, and the legend in one of its corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shell/gl/list_renderer.h"
#include "shell/pane/legend.h"
#include "shell/pane/pane_area.h"

namespace sightline {

class PaneTexts {
public:
    /// The pane that the next calls are for. No legend yet.
    void begin(const Area& area, const PaneSize& size);
    /// Whether the mouse has come to the legend, which then has all its rows, or has left it, since it was added.
    bool legend_turned(const Ui& ui) const { return legend_.w > 0 && points_at_legend(ui) != whole_; }
    /// Beside the picture where there is room for it, with as many rows as fit. Else in a corner of the picture where
    /// it hides none of the points; not where it would take most of it, which helps nobody.
    void add_legend(const Ui& ui, std::span<const LegendRow> rows, const std::optional<ColourBar>& bar,
                    const Colours& colours, std::span<const ImVec2> busy);
    /// Labels keep off the legend and what else is taken.
    void place(const Ui& ui, std::span<const Label> labels, std::function<ImVec2(const Vec<2>&)> to_window,
               std::span<const Area> taken = {});

    /// The swatches of a legend in the picture with OpenGL, onto a target that the pane fills.
    void draw_legend() const;
    /// Those of a legend beside it, onto the default framebuffer.
    void draw_legend_beside() const;
    /// Texts of the labels, which are as they were placed, and of the legend.
    void draw(ImDrawList& list, const Ui& ui, std::span<const Label> labels) const;

    const std::vector<LabelSpot>& spots() const { return spots_; }

private:
    bool points_at_legend(const Ui& ui) const;
    bool fits_beside(const Ui& ui, std::vector<LegendRow>& rows, const std::function<void()>& make);
    /// With the lower left corner of the picture at these pixels.
    void draw_swatches(int x, int y) const;

    bool whole_ = false;   ///< the legend has all rows
    bool beside_ = false;  ///< it stands beside the picture
    Area area_;
    PaneSize size_;
    LegendBox legend_;
    Area legend_area_;
    std::vector<LabelSpot> spots_, legend_spots_;
    LabelMemory memory_;
    ListRenderer legend_renderer_;
};

}  // namespace sightline
