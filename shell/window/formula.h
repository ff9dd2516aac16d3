// A formula whose terms have colours, the same in words and in the picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shell/window/ui.h"

namespace sightline {

Colour term_colour(KeyAbout about);

struct FormulaLook {
    ImFont* font = nullptr;
    float size = 0;         ///< of the letters, ImGui units
    float room = 0;         ///< width; it wraps between pieces and between words
    bool captions = false;  ///< each term's name under its number
};

float formula_height(std::span<const KeyPart> parts, const FormulaLook& look);

/// Draws it, and says which term lies under `mouse`.
KeyAbout draw_formula(ImDrawList& list, const ImVec2& at, std::span<const KeyPart> parts, const FormulaLook& look,
                      const Colour& ink, const ImVec2& mouse);

}  // namespace sightline
