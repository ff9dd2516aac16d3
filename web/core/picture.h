// The picture of a page: draw lists as flat memory, labels with their places, the legend; and the hand on it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "web/core/page.h"

namespace sightline {

/// Makes the lists of a pane (0, or 1 in a comparison) for so many pixels, of which `unit` make one pixel of a screen
/// of usual density and 4/3 `unit` a point. As JSON: where points and shapes lie in memory, styles, labels, legend.
std::string picture_json(Page& page, int pane, double width, double height, double unit);

/// What lies at a point of the plane: cell, segment, whether the eye is within reach, and words about it.
std::string under_json(Page& page, const Vec<2>& at, double reach);

/// A click: selects what lies there, as the window does; in three dimensions `at` is of the picture's plane.
void tap(Page& page, const Vec<2>& at, double reach);
/// A second one: runs until that cell is projected.
void tap_twice(Page& page, const Vec<2>& at);

/// A drag begins: of the eye where that is within reach, in the edit mode of a wall or an end of one, else of the
/// picture.
Held take(Page& page, const Vec<2>& at, double reach);
/// To a point of the plane as it was shown when the drag began.
void drag(Page& page, const Vec<2>& to);
/// It ends; `back`: as if it had not been.
void let_go(Page& page, bool back);

/// The scene point stays where it is.
void magnify(Page& page, const Vec<2>& fixed, double factor);

}  // namespace sightline
