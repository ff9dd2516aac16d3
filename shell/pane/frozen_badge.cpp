// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/frozen_badge.h"

#include "shell/window/theme.h"

namespace sightline {

namespace {

struct Badge {
    std::string text;
    Area area;
    float size, pad;
};

template <int D>
Badge badge_of(const Ui& ui, const Workbench<D>& bench, const Area& area, float down) {
    const Frozen part = bench.session.frozen_part();
    std::string text = "frozen";
    if (part != Frozen::all) text += ": " + std::string(frozen_words[static_cast<std::size_t>(part)]);
    ImFont* const font = ui.fonts.bold;
    const float size = font->FontSize / ui.framebuffer, pad = 5 * ui.unit, margin = 8 * ui.unit;
    const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, text.c_str());
    return {
        std::move(text), {area.x + margin, area.y + margin + down, extent.x + 2 * pad, extent.y + 2 * pad}, size, pad};
}

}  // namespace

template <int D>
void draw_frozen_badge(ImDrawList& list, const Ui& ui, Workbench<D>& bench, const Area& area, float down) {
    if (!bench.session.frozen()) return;
    const Badge badge = badge_of(ui, bench, area, down);
    list.AddRectFilled(badge.area.min(), badge.area.max(), colour(theme::accent), 4 * ui.unit);
    list.AddText(ui.fonts.bold, badge.size, {badge.area.x + badge.pad, badge.area.y + badge.pad}, IM_COL32_WHITE,
                 badge.text.c_str());
    bench.places.push_back({"badge: " + badge.text, badge.area.x, badge.area.y, badge.area.w, badge.area.h});
}

template <int D>
bool frozen_badge_takes_mouse(Ui& ui, const Workbench<D>& bench, const Area& area, float down) {
    if (!bench.session.frozen() || !ImGui::IsItemHovered() ||
        !badge_of(ui, bench, area, down).area.contains(ImGui::GetIO().MousePos))
        return false;
    if (ImGui::IsItemClicked()) ui.act("unfreeze");
    ImGui::SetTooltip("What is drawn stays as it was, only your own view moves. A click ends this, as Shift+F does.");
    return true;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                   \
    template void draw_frozen_badge<D>(ImDrawList&, const Ui&, Workbench<D>&, const Area&, float); \
    template bool frozen_badge_takes_mouse<D>(Ui&, const Workbench<D>&, const Area&, float);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
