// What every part of the window needs to draw itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/space/tree.h"
#include "shell/commands/completion.h"
#include "shell/panels/panel.h"
#include "shell/window/timeline_data.h"

namespace sightline {

/// A rectangle of the window, in ImGui's units (which may be several pixels), y down.
struct Area {
    float x = 0, y = 0, w = 0, h = 0;
    bool contains(const ImVec2& p) const { return p.x >= x && p.x < x + w && p.y >= y && p.y < y + h; }
    ImVec2 min() const { return {x, y}; }
    ImVec2 max() const { return {x + w, y + h}; }
};

class FontHalo;

struct Fonts {
    ImFont *text = nullptr, *bold = nullptr, *mono = nullptr;
    ImFont* label = nullptr;  ///< numbers on cells
    std::shared_ptr<const FontHalo> label_halo;
    ImFont* banner = nullptr;  ///< the formula of the projector mode
};

/// A line that was said to the person.
struct Message {
    std::string text;
    bool bad = false;
};

/// The rows of the panel in one column, kept while the revision stays.
struct ShownRows {
    std::string panel;
    std::uint64_t revision = 0;
    std::vector<Row> rows;
};

/// Where the arrow keys stand in the list of scenes (scene_filter.h).
struct SceneList {
    std::string filter;
    std::size_t row = 0, column = 0;
    bool moved = false;  ///< to be brought into view
};

struct Ui {
    float unit = 1;         ///< ImGui units per pixel of the layout at scale 1
    float framebuffer = 1;  ///< framebuffer pixels per ImGui unit
    Fonts fonts;
    std::vector<Message> messages;  ///< oldest first
    std::string completed_for;      ///< the line that `completion` was made for: making it reads folders
    Completion completion;
    std::vector<std::string> typed;  ///< command lines, oldest first
    int line_opens = 0;              ///< so many frames from now on what was in the line is not marked
    bool line_failed = false;        ///< it stays to be read, marked: what is typed replaces it
    int recalled = 0;                ///< so many back in them the line stands; 0: what is being typed
    std::string draft;               ///< what was being typed before the first of them came back
    std::size_t said_before = 0;     ///< so many of them belong to an earlier action than the last
    /// Counts what may have changed the bench; what is drawn from it is made again when this differs.
    std::uint64_t revision = 1;
    std::array<ShownRows, 2> columns;  ///< by Column
    bool awaits_text = false;          ///< a text field was opened and will take the keyboard: keys are letters already
    std::uint64_t followed = 0;        ///< the revision whose lit line was brought into view
    TimelineData timeline;
    /// The cell under the mouse: whatever part it is over writes it here, and the next frame has it in
    /// Workbench::hovered_cell for all parts to outline.
    std::uint32_t hovering = none;
    KeyLight lighting{};  ///< the same of the term of a key, for Workbench::lit
    Area legend_room;  ///< beside the picture, for its legend; without a width there is none
    /// The mouse was moved since the last key: otherwise what lies under it is not what the person looks at.
    bool mouse_awake = false;
    /// Runs commands; says what went wrong instead of throwing.
    std::function<void(const std::string& commands)> act;
    SceneList scenes;
};

inline ImU32 colour(const Colour& c) { return IM_COL32(c.r, c.g, c.b, c.a); }

}  // namespace sightline
