// Where a label of a draw list stands on the page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shell/figure/layout.h"

namespace sightline {

struct PlacedLabel {
    TextRun run;        ///< no text when the label is a bare disc
    Vec<2> centre{};    ///< of text and disc
    double radius = 0;  ///< of the disc behind it; 0 without one
    Rect box;           ///< of text, halo and disc
};

/// Labels stay inside their panel: those near its border move in. Nothing when the label's point lies outside.
std::optional<PlacedLabel> place_label(const Label& label, const Layout::Panel& panel, const Layout& layout,
                                       const Font& font);

}  // namespace sightline
