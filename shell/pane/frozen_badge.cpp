// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/frozen_badge.h"

#include "shell/window/theme.h"

namespace sightline {

template <int D>
void draw_frozen_badge(ImDrawList& list, const Ui& ui, Workbench<D>& bench, const Area& area, float down) {
    if (!bench.session.frozen()) return;
    const Frozen part = bench.session.frozen_part();
    const std::string text =
        part == Frozen::all ? "frozen" : "frozen: " + std::string(frozen_words[static_cast<std::size_t>(part)]);
    ImFont* const font = ui.fonts.bold;
    const float size = font->FontSize / ui.framebuffer, pad = 5 * ui.unit, margin = 8 * ui.unit;
    const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, text.c_str());
    const ImVec2 from{area.x + margin, area.y + margin + down},
        to{from.x + extent.x + 2 * pad, from.y + extent.y + 2 * pad};
    list.AddRectFilled(from, to, colour(theme::accent), 4 * ui.unit);
    list.AddText(font, size, {from.x + pad, from.y + pad}, IM_COL32_WHITE, text.c_str());
    bench.places.push_back({"badge: " + text, from.x, from.y, to.x - from.x, to.y - from.y});
}

template void draw_frozen_badge<2>(ImDrawList&, const Ui&, Workbench<2>&, const Area&, float);
template void draw_frozen_badge<3>(ImDrawList&, const Ui&, Workbench<3>&, const Area&, float);

}  // namespace sightline
