// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/pane_area.h"

#include <algorithm>
#include <cmath>

namespace sightline {

Area pane_area(const Area& area, std::size_t pane, std::size_t count) {
    if (count == 1) return area;
    constexpr float gap = 3;
    const float w = std::floor((area.w - gap) / 2);
    return {pane == 0 ? area.x : area.x + area.w - w, area.y, w, area.h};
}

PaneSize pane_size(const Ui& ui, const Area& area, bool projector) {
    const auto pixels = [&](float v) { return static_cast<int>(std::lround(v * ui.framebuffer)); };
    PaneSize size{pixels(area.x), 0, std::max(1, pixels(area.w)), std::max(1, pixels(area.h))};
    size.y = pixels(ImGui::GetIO().DisplaySize.y) - pixels(area.y) - size.h;
    size.px_per_pt = 4.0 / 3 * ui.unit * ui.framebuffer;
    size.line_scale = projector ? 2 : 1;
    return size;
}

}  // namespace sightline
