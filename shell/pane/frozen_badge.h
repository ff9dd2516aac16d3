// A badge in a picture whose culling view is frozen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"
#include "shell/window/ui.h"

namespace sightline {

/// In the upper left corner of the area, where the view is frozen; `down` pixels lower.
template <int D>
void draw_frozen_badge(ImDrawList& list, const Ui& ui, Workbench<D>& bench, const Area& area, float down = 0);

/// Whether the mouse is on the badge, after the ImGui item that covers the picture: a click ends the freeze, and the
/// picture behind has no part in it.
template <int D>
bool frozen_badge_takes_mouse(Ui& ui, const Workbench<D>& bench, const Area& area, float down = 0);

}  // namespace sightline
