// Cutting outlines to a rectangle and hatching them, in page points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shell/figure/page.h"

namespace sightline {

/// The part of a polygon inside the rectangle; where it was cut it follows the rectangle's border. May be empty.
std::vector<Vec<2>> clip_polygon(std::span<const Vec<2>> polygon, const Rect& rect);

/// The parts of a polyline inside the rectangle, as open runs.
Path clip_polyline(std::span<const Vec<2>> line, const Rect& rect);

/// The length of the segment's part inside the rectangle.
double clipped_length(const Vec<2>& a, const Vec<2>& b, const Rect& rect);

/// The lines of a hatch inside a polygon (non-zero winding), `pitch` points apart; dots are runs of one point twice.
/// All hatches share one grid on the page, so that those of neighbours meet.
Path hatch_lines(std::span<const Vec<2>> polygon, Hatch hatch, double pitch);

}  // namespace sightline
