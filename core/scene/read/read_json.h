// The project's own scene format. One JSON object:
//   {"format": "sightline-scene", "version": 1, "dimension": 2,
//    "id": "…", "title": "…", "lesson": "…", "seed": 7,
//    "segments": [[x0, y0, x1, y1], …],
//    "view": {"eye": [x, y], "look_at": [x, y], "fov": 60},
//    "origin": [x, y],
//    "objects": {"names": ["wall", …], "of": [0, 0, …]}}
// format, version, dimension and segments are required. Coordinates are taken as they are, never recentred; origin
// (default 0) only says what was subtracted earlier. fov is in degrees and defaults to 60. objects names groups of
// segments: "of" has the number of a name for each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace sightline {

/// `name` begins every error line and is the id of a scene that has none. Unknown members become warnings. A scene
/// with no "view" gets default_view(). Throws InputError "name: place: reason".
Scene<2> read_json(std::string_view text, const std::string& name);

/// Reading this back gives the same primitives, origin, view, seed and texts, bit for bit. Finite coordinates only.
std::string write_json(const Scene<2>& scene);

}  // namespace sightline
