// How far something long is, drawn over the window while no frame of it can be: between two frames or within one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL.h>

#include <string_view>

#include "core/base/stopwatch.h"
#include "shell/window/ui.h"

namespace sightline {

class ProgressCard {
public:
    /// Something begins that may take long.
    void begin() { since_ = {}; }
    /// A word of it (core/base/progress.h); draws from half a second on, at most ten times a second, and takes in the
    /// window's events, which wait for the next frame. Leaves the default framebuffer bound and cleared.
    void show(SDL_Window* window, const Ui& ui, std::string_view what, double share);

private:
    Stopwatch since_, drawn_;
    bool shown_ = false;
};

}  // namespace sightline
