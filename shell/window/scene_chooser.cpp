// The scenes over the picture: a line to type into, and what it leaves, with pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/scene/make/catalogue.h"
#include "shell/window/parts.h"
#include "shell/window/scene_filter.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Those of the viewer, then what was opened lately and is none of them.
template <int D>
std::vector<SceneChoice> all_choices(const Workbench<D>& bench, const Stage& stage) {
    std::vector<SceneChoice> all = stage.scenes;
    for (const std::string& name : bench.recent) {
        const bool known = std::any_of(all.begin(), all.end(), [&](const SceneChoice& c) { return c.name == name; });
        if (known || find_in_catalogue<D>(name)) continue;
        all.push_back({name, name.substr(name.rfind('/') + 1), name, "Your files", "open \"" + name + "\""});
    }
    return all;
}

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// The place that the arrow keys lead to; the first one after the filter was changed.
SceneSpot chosen_spot(Ui& ui, const SceneRows& rows, const std::string& filter, int page) {
    const int down = is_pressed(ImGuiKey_DownArrow) - is_pressed(ImGuiKey_UpArrow) +
                     page * (is_pressed(ImGuiKey_PageDown) - is_pressed(ImGuiKey_PageUp));
    const int right = is_pressed(ImGuiKey_RightArrow) - is_pressed(ImGuiKey_LeftArrow);
    SceneList& list = ui.scenes;
    if (list.filter != filter || ImGui::IsWindowAppearing()) list = {filter, 0, 0, true};
    const SceneSpot before{list.row, list.column}, now = moved_spot(rows, before, down, right);
    list.moved = list.moved || !(now == before);
    list.row = now.row;
    list.column = now.column;
    return now;
}

/// A card with picture, title and sentence; whether it was clicked.
bool card(Ui& ui, const Stage& stage, const SceneChoice& choice, const ImVec2& size, float thumb_w, bool lit) {
    const float pad = 7 * ui.unit, thumb_h = size.y - 2 * pad;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(choice.name.c_str(), size);
    if (!ImGui::IsItemVisible()) return clicked;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (lit || ImGui::IsItemHovered())
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, colour(theme::hover), 3 * ui.unit);
    if (lit) list.AddRect(at, {at.x + size.x, at.y + size.y}, colour(theme::accent), 3 * ui.unit, 0, 2 * ui.unit);
    const ImVec2 min{at.x + pad, at.y + pad}, max{min.x + thumb_w, min.y + thumb_h};
    const GLuint texture = stage.thumbnail ? stage.thumbnail(choice, static_cast<int>(thumb_w * ui.framebuffer),
                                                             static_cast<int>(thumb_h * ui.framebuffer))
                                           : 0;
    list.AddRectFilled(min, max, IM_COL32_WHITE);
    if (texture != 0) list.AddImage(reinterpret_cast<ImTextureID>(std::uintptr_t{texture}), min, max, {0, 1}, {1, 0});
    list.AddRect(min, max, colour(theme::line));
    const float x = max.x + pad, room = at.x + size.x - pad - x, font = ImGui::GetFontSize();
    list.PushClipRect({x, min.y}, {x + room, at.y + size.y - pad}, true);
    list.AddText(ui.fonts.bold, font, {x, min.y}, colour(theme::ink), choice.title.c_str(), nullptr, room);
    const float below = ui.fonts.bold->CalcTextSizeA(font, 1e6f, room, choice.title.c_str()).y + 0.3f * font;
    list.AddText(ui.fonts.text, font * 0.9f, {x, min.y + below}, colour(theme::faint), choice.sentence.c_str(), nullptr,
                 room);
    list.PopClipRect();
    return clicked;
}

/// The line that takes all that is typed while the list is open. Whether Enter was pressed in it.
template <int D>
bool filter_line(Ui& ui, Workbench<D>& bench) {
    ImGui::PushFont(ui.fonts.bold);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Choose a scene");
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(std::min(26 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x));
    const bool lost = !ImGui::GetIO().WantTextInput && !ImGui::IsAnyMouseDown() && !bench.desk.console;
    if (ImGui::IsWindowAppearing() || lost) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint("##filter", "type a part of a name", &bench.desk.chooser_text,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    note_place(bench, "scene filter");
    const char* const hint = "Arrows and Enter choose, Esc closes";
    ImGui::SameLine();
    if (ImGui::CalcTextSize(hint).x < ImGui::GetContentRegionAvail().x)
        ImGui::TextDisabled("%s", hint);
    else
        ImGui::NewLine();
    return entered;
}

}  // namespace

template <int D>
void scene_chooser(Ui& ui, Workbench<D>& bench, const Stage& stage, const Area& area) {
    begin_overlay("scenes", area);
    const bool entered = filter_line(ui, bench);
    const std::string& filter = bench.desk.chooser_text;
    const float thumb_w = 150 * ui.unit, gap = 12 * ui.unit, h = 114 * ui.unit;
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    const auto columns = static_cast<std::size_t>(std::max(1.0f, std::floor(room / (420 * ui.unit))));
    const float w = (room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const std::vector<SceneChoice> choices = all_choices(bench, stage);
    const SceneRows rows = scene_rows(choices, filter, columns);
    const int page = std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().y / (h + gap)));
    const SceneSpot spot = chosen_spot(ui, rows, filter, page);
    const SceneChoice* chosen = nullptr;
    ImGui::BeginChild("list");
    if (rows.rows.empty()) {
        ImGui::Text("No scene matches '%s'. Backspace takes letters back.", filter.c_str());
        note_place(bench, "no scene matches '" + filter + "'");
    }
    const std::string* group = nullptr;
    for (std::size_t r = 0; r < rows.rows.size(); ++r)
        for (std::size_t c = 0; c < rows.rows[r].size(); ++c) {
            const SceneChoice& choice = choices[rows.rows[r][c]];
            if (!group || *group != choice.group) {
                ImGui::Dummy({1, 4 * ui.unit});
                ImGui::PushFont(ui.fonts.bold);
                ImGui::TextUnformatted(choice.group.c_str());
                ImGui::PopFont();
                note_place(bench, "scenes " + choice.group);
            }
            group = &choice.group;
            if (c > 0) ImGui::SameLine(0, gap);
            const bool lit = spot == SceneSpot{r, c};
            if (card(ui, stage, choice, {w, h}, thumb_w, lit) || (lit && entered)) chosen = &choice;
            note_place(bench, (lit ? "scene chosen " : "scene ") + choice.name);
            if (lit && ui.scenes.moved) ImGui::SetScrollHereY(r == 0 ? 1.0f : 0.5f);
        }
    ui.scenes.moved = false;
    ImGui::EndChild();
    ImGui::End();
    if (!chosen) return;
    bench.desk.chooser = false;
    bench.desk.chooser_text.clear();
    ui.act(chosen->command.empty() ? "open " + chosen->name : chosen->command);
}

template void scene_chooser<2>(Ui&, Workbench<2>&, const Stage&, const Area&);
template void scene_chooser<3>(Ui&, Workbench<3>&, const Stage&, const Area&);

}  // namespace sightline
