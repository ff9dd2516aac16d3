// Where a pane stands: in the window, and in its framebuffer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "shell/window/ui.h"

namespace sightline {

/// The part of the area that a pane has: all of it, or one half.
Area pane_area(const Area& area, std::size_t pane, std::size_t count);

/// What its picture is drawn for.
struct PaneSize {
    int x = 0, y = 0, w = 0, h = 0;  ///< framebuffer pixels, y up
    double px_per_pt = 0, line_scale = 1;
    bool operator==(const PaneSize&) const = default;
};

/// What a window asks of its panes in a frame.
struct PaneFrame {
    std::uint64_t revision = 0;  ///< a new one: the session or the options may have changed
    std::uint64_t run = 0;       ///< Workbench::run
    bool projector = false, with_legend = false;
    bool animate = false;  ///< what a step changes fades in
};

PaneSize pane_size(const Ui& ui, const Area& area, bool projector);

}  // namespace sightline
