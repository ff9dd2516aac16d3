// Puts a laid-out figure on a canvas.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/figure/canvas.h"
#include "shell/figure/layout.h"

namespace sightline {

/// Background, panels, titles, legend, colour bar and caption.
void paint(Canvas& canvas, const Figure& figure, const Layout& layout, const Font& font);

}  // namespace sightline
