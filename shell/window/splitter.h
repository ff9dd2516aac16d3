// A strip between two parts of the window that moves their border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/window/ui.h"

namespace sightline {

/// What the strip gives its part: the part lies from the strip to `fixed`.
struct SplitterRange {
    bool upright = true;        ///< the strip stands and moves sideways
    float fixed = 0;            ///< x or y of the part's edge that stays
    float least = 0, most = 0;  ///< sizes of the part, in the window's units
};

/// Thickness of every strip.
inline float splitter_width(const Ui& ui) { return 5 * ui.unit; }

/// The part's size while it is dragged, in pixels at scale 1 as the desk keeps them; else `size`.
double splitter(const Ui& ui, const char* name, const Area& strip, const SplitterRange& split, double size);

}  // namespace sightline
