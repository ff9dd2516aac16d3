// The mouse as its events tell it, frame by frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL_events.h>

#include <array>
#include <optional>

#include "shell/window/ui.h"

namespace sightline {

/// Older backends of Dear ImGui ask where the mouse is when the frame begins. Where frames are slow that is not where
/// it was when a button went down, and a fast drag becomes a click at its far end; while a button holds the pointer,
/// X11 does not tell at all.
class MouseState {
public:
    /// Whether the event has to wait for the next frame: a frame ends with a change of the buttons, so that a key that
    /// follows a click finds what it opened, and a button goes up where the frame before has seen the mouse.
    bool waits(const SDL_Event& event) const;
    void take(const SDL_Event& event);
    /// Begins to gather the events of a frame.
    void begin() { moved_ = changed_ = false; }
    /// To be called between the backend's and ImGui's NewFrame.
    void give(ImGuiIO& io) const;

private:
    std::optional<ImVec2> at_;    ///< nothing: not over the window
    std::array<bool, 3> down_{};  ///< left, right, middle
    bool moved_ = false, changed_ = false;
};

/// Ctrl, Shift and Alt as they were when the key was pressed. Older backends ask which are held now, and a quick Ctrl+A
/// is over by then. To be called after the backend has taken the event.
void take_modifiers(const SDL_Event& event, ImGuiIO& io);

}  // namespace sightline
