// How much of a picture a box would hide.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shell/figure/layout.h"

namespace sightline {

/// A measure of what is drawn under the box: lengths of outlines in points; lines and labels weigh more, insets more
/// than all else. Of a solid it is the outlines of faces and triangles, also of hidden ones; of many, some that are
/// spread over all.
double covered(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout, const Font& font,
               const Rect& box);

/// Of the corners of all panels that are big enough, the one where a box of this size hides least on all pages
/// together.
Rect emptiest_corner(std::span<const Figure> pages, std::span<const Layout> layouts, const Font& font, double w,
                     double h, double inset);

}  // namespace sightline
