// The small field in the picture into which a note is written, with the steps in which it shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "shell/desk/desk.h"
#include "shell/window/ui.h"

namespace sightline {

class NoteField {
public:
    /// Opens it at a point of the window. Enter runs `command` with "{FROM-TO} TEXT" behind it and then `after`; Escape
    /// (close) drops what was typed. `to` none: to the end.
    void open(const ImVec2& at, std::string command, std::string after, std::string text = "", std::uint32_t from = 0,
              std::uint32_t to = none);
    /// For a new note of the tool's kind at an anchor as the command `note` takes it; then nothing more is placed.
    void open_new(const ImVec2& at, Tool tool, const std::string& anchor, const char* offset);
    /// False when it was not open.
    bool close();
    bool is_open() const { return open_; }

    /// Draws it, inside the area.
    void draw(Ui& ui, const Area& area);

private:
    bool open_ = false, focus_ = false;
    ImVec2 at_{};
    std::string command_, after_, text_, from_, to_;
};

}  // namespace sightline
