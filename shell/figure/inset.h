// Where the insets of a panel stand on the page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shell/figure/layout.h"

namespace sightline {

struct PlacedInset {
    Rect box;    ///< of the picture
    Rect paper;  ///< behind the title, in the lower left corner of the box
    TextRun title;
};

/// In the upper right corner of the panel, below each other; smaller than usual where they would find no room.
std::vector<PlacedInset> place_insets(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout,
                                      const Font& font);

}  // namespace sightline
