// What a viewer puts into the shell's window: its picture, and the scenes that it can open.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <functional>
#include <string>
#include <vector>

#include "shell/window/ui.h"

namespace sightline {

/// A row of the scene chooser.
struct SceneChoice {
    std::string name;  ///< what the command `open` takes
    std::string title, sentence;
    std::string group{};    ///< the heading that it stands under
    std::string command{};  ///< what a click runs; empty: "open NAME"
    std::string picture{};  ///< the scene or state file that its thumbnail shows; empty: NAME
};

struct Stage {
    /// Brings the picture up to date with the bench and draws it with OpenGL under ImGui.
    std::function<void(Ui&, const Area&)> draw;
    /// Labels, legend, tooltip and the mouse, inside an ImGui window that covers the area.
    std::function<void(Ui&, const Area&)> interact;
    /// Ends a drag or another gesture without effect; false when there is none.
    std::function<bool()> cancel;

    /// Whether the picture wants this key for itself now, e.g. held down to fly; empty: never.
    std::function<bool(const std::string& key)> takes_key;
    /// Whether the next frame is to be drawn without waiting for an event; empty: never.
    std::function<bool()> lively;

    std::vector<SceneChoice> scenes;
    /// A picture of the scene as a texture of this size in pixels, made when first asked for; 0: none yet, ask again.
    std::function<GLuint(const SceneChoice&, int width, int height)> thumbnail;
};

}  // namespace sightline
