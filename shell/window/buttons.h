// Buttons with icons, for the bars that play something.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/window/ui.h"

namespace sightline {

/// Shapes on buttons, drawn in a square of side 1.
enum class Icon { start, back, play, pause, step, end };

/// True when it was pressed. `tip` is shown under the mouse.
bool icon_button(const char* id, Icon icon, bool enabled, const char* tip);

}  // namespace sightline
