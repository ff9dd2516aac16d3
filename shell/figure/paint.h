// Puts a laid-out figure on a canvas.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/solid_list.h"
#include "shell/figure/canvas.h"
#include "shell/figure/layout.h"

namespace sightline {

/// Background, panels, titles, legend, colour bar and caption. Throws WorkError when a panel has a solid and there is
/// no draw_solid, or when that makes another number of pixels than it was asked for.
void paint(Canvas& canvas, const Figure& figure, const Layout& layout, const Font& font,
           const DrawSolid& draw_solid = {});

}  // namespace sightline
