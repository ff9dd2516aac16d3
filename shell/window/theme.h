// Fonts, sizes and colours of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "shell/window/ui.h"

namespace sightline {

/// Colours of the panels, beside the palette of the picture.
namespace theme {
inline constexpr Colour paper{250, 250, 248}, panel{243, 244, 245}, line{205, 209, 214}, ink{20, 22, 26},
    faint{88, 94, 102}, accent{0, 90, 170}, lit{255, 240, 190}, hover{222, 232, 243}, good{0, 105, 80}, bad{170, 45, 0},
    playing{0, 125, 105}, paused{170, 105, 0};
}  // namespace theme

/// Of a line in the current font, in ImGui units.
inline float width_of_line(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

/// Loads the fonts at these sizes (ImGui units) for a framebuffer of this density, and sets the style to match.
/// Replaces what was loaded before. Throws WorkError that names the package when the font is not installed.
Fonts load_theme(float text_size, float label_size, float unit, float framebuffer);

}  // namespace sightline
