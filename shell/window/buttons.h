// Buttons with icons, and the coloured word of a state, for the bars that play something.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "shell/window/ui.h"

namespace sightline {

/// Shapes on buttons, drawn in a square of side 1.
enum class Icon { start, back10, back, play, pause, step, step10, end, record };

/// True when it was pressed. `tip` is shown under the mouse.
bool icon_button(const char* id, Icon icon, bool enabled, const char* tip);

/// All words of one bar in plates of one width.
void badge(const Ui& ui, std::string_view word, const Colour& fill);

}  // namespace sightline
