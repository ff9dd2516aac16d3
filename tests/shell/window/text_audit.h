// What of a frame's texts cannot be read, from what is drawn: letters cut by the part that they stand in, and letters
// of two texts over one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shell/window/ui.h"

namespace sightline::test {

/// Letters that follow one another in a line.
struct TextRunDrawn {
    ImVec4 box{};
    ImVec4 clip{};
    std::string window;
    std::string letters;
    std::vector<ImVec4> glyphs;  ///< a box a letter
    bool over_all = false;       ///< of a tooltip or a menu, which may cover what is below
    bool scrolls = false;        ///< in its height: what is cut there can be reached
};

inline std::string letter_at(const ImVec2& uv) {
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (std::abs(glyph.U0 - uv.x) < 1e-6f && std::abs(glyph.V0 - uv.y) < 1e-6f) {
                char text[5] = {};
                ImTextCharToUtf8(text, glyph.Codepoint);
                return text;
            }
    return "?";
}

/// Of the frame drawn last, in the order of drawing.
inline std::vector<TextRunDrawn> drawn_texts() {
    std::vector<TextRunDrawn> runs;
    const ImTextureID letters = ImGui::GetIO().Fonts->TexID;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        const ImGuiWindow* const window = list._OwnerName ? ImGui::FindWindowByName(list._OwnerName) : nullptr;
        const bool over = window && (window->Flags & (ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Popup));
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback || command.GetTexID() != letters) continue;
            float right = 0;  // of the letter before
            bool fresh = true;
            for (unsigned i = 0; i + 5 < command.ElemCount;) {
                const ImDrawIdx* const index = list.IdxBuffer.Data + command.IdxOffset + i;
                const ImDrawVert* const v = list.VtxBuffer.Data + command.VtxOffset;
                const ImDrawVert &a = v[index[0]], &b = v[index[1]], &c = v[index[2]];
                const bool quad = index[3] == index[0] && index[4] == index[2] && a.pos.y == b.pos.y &&
                                  b.pos.x == c.pos.x && a.uv.y == b.uv.y && b.uv.x == c.uv.x && a.uv.y < c.uv.y &&
                                  a.uv.x < c.uv.x;
                if (!quad) {
                    i += 3;
                    continue;
                }
                i += 6;
                // A letter belongs to the line where it stands beside the one before, no further off than a space.
                const float height = fresh ? 0 : std::max(runs.back().box.w - runs.back().box.y, c.pos.y - a.pos.y);
                const bool apart = fresh || a.pos.x < right - 2 || a.pos.x > right + 0.7f * height ||
                                   c.pos.y < runs.back().box.y - 0.3f * height ||
                                   a.pos.y > runs.back().box.w + 0.3f * height;
                if (apart) {
                    runs.push_back({{a.pos.x, a.pos.y, c.pos.x, c.pos.y},
                                    command.ClipRect,
                                    list._OwnerName,
                                    {},
                                    {},
                                    over,
                                    window && window->ScrollMax.y > 0});
                    fresh = false;
                }
                TextRunDrawn& run = runs.back();
                run.box = {std::min(run.box.x, a.pos.x), std::min(run.box.y, a.pos.y), std::max(run.box.z, c.pos.x),
                           std::max(run.box.w, c.pos.y)};
                run.letters += letter_at(a.uv);
                run.glyphs.emplace_back(a.pos.x, a.pos.y, c.pos.x, c.pos.y);
                right = c.pos.x;
            }
        }
    }
    return runs;
}

/// One line for each text that cannot be read.
inline std::vector<std::string> unreadable_texts() {
    constexpr float slack = 1.5f;  // pixels: letters touch, and boxes are rounded
    const std::vector<TextRunDrawn> runs = drawn_texts();
    std::vector<std::string> faults;
    const auto name = [](const TextRunDrawn& run) {
        return "'" + run.letters + "' in " + run.window + " (" + std::to_string(std::lround(run.box.x)) + " to " +
               std::to_string(std::lround(run.box.z)) + " of " + std::to_string(std::lround(run.clip.x)) + " to " +
               std::to_string(std::lround(run.clip.z)) + ")";
    };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const TextRunDrawn& run = runs[i];
        const ImVec4 &box = run.box, &clip = run.clip;
        const bool gone = box.y >= clip.w - slack || box.w <= clip.y + slack;  // scrolled away
        if (gone && run.scrolls) continue;
        if (box.x < clip.x - slack || box.z > clip.z + slack) faults.push_back("cut at a side: " + name(run));
        if (!run.scrolls && (box.y < clip.y - slack || box.w > clip.w + slack))
            faults.push_back("cut above or below: " + name(run));
        for (std::size_t j = 0; j < i; ++j) {
            const TextRunDrawn& other = runs[j];
            if (run.over_all != other.over_all) continue;
            // Of what is drawn, only the parts that are not clipped away.
            const auto meet = [&](const ImVec4& a, const ImVec4& b) {
                const float x = std::max({a.x, b.x, run.clip.x, other.clip.x}),
                            y = std::max({a.y, b.y, run.clip.y, other.clip.y}),
                            x_end = std::min({a.z, b.z, run.clip.z, other.clip.z}),
                            y_end = std::min({a.w, b.w, run.clip.w, other.clip.w});
                return x_end - x > slack && y_end - y > slack;
            };
            const auto letters_meet = [&] {
                return std::any_of(run.glyphs.begin(), run.glyphs.end(), [&](const ImVec4& a) {
                    return std::any_of(other.glyphs.begin(), other.glyphs.end(),
                                       [&](const ImVec4& b) { return meet(a, b); });
                });
            };
            if (meet(run.box, other.box) && letters_meet())
                faults.push_back("over one another: " + name(run) + " and " + name(other));
        }
    }
    return faults;
}

}  // namespace sightline::test
