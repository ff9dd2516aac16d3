// What a diagram of the article asks beside what the page shows: numbers by name, and the places that they speak of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "web/core/page.h"

namespace sightline {

/// Numbers of the run where it stands, by name: {"visible": {"value": 22, "text": "22"}, …}; words have a text only.
///   segments, in_view, hidden (in view, not visible), visible, drawn, found (visible, drawn), missed, wasted, and as
///   shares visible_share, drawn_share, coverage, wrong (of the pixels), zero_keys; per_visible; budget
///   method, guarantee; verdict: of the box that is selected, or else was last taken; technique, region: by viewpoint
///   step, steps, changed (boxes, Coorg and Teller); cell, key, step_drawn, step_visible, cell_share, runner_up,
///   runner_up_key: of the last step; next: the cell that the next one takes; seed, front, projected, cells, fullest
///   (the most segments in a cell), boxes, node, tests, rooms
///   crossed, crossed_drawn, deepest (segments that rays cross), inversions: these take long, and are told where
///   `asked` has their names
/// What the run does not have is left out. "view" has eye, look and fov. Planes only.
std::string numbers_json(Page& page, const std::string& asked);

/// Where in the plane a name of numbers_json() lies, or "cell 3", "segment 3", "node 3", "ray X,Y": lines as in
/// light_json(). Empty for what has no place.
std::string place_json(Page& page, const std::string& name);

/// The names whose place holds what lies at a point, in words as under_json() says it.
std::string names_json(Page& page, const Vec<2>& at, double reach);

/// Per column of the view, from left to right, how many segments its middle ray crosses: of the scene, and of what is
/// drawn so far.
std::string crossed_json(Page& page, int columns);

/// The trade-off as far as it is measured: dots with milliseconds, primitives and wrong pixels.
std::string dots_json(Page& page);

/// Works out entries of a table by viewpoint that `work-out` asked for; true when there is more to do.
bool work_out(Page& page, double milliseconds);

/// Forgets what undo would bring back, and what was said: a diagram has no undo.
void forget_past(Page& page);

}  // namespace sightline
