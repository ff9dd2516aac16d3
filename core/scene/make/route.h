// Inside core/scene: flight paths out of way points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/base/random.h"
#include "core/scene/flight_path.h"

namespace sightline {

/// An eye that goes from the first to the last point in equal steps and looks at where it will be `ahead` metres
/// later; beyond the last point it looks straight on. At least two points, no two in a row the same.
FlightPath<3> along(std::string id, std::span<const Vec<3>> points, std::size_t frames, double ahead, double fov);

/// Adds points to a way, about 3 metres apart, from its last one to `to`; all but `to` stand aside by up to `sway`.
void stroll(std::vector<Vec<2>>& way, const Vec<2>& to, Random& random, double sway);

/// A person on foot: `frames` steps of 5 cm along a way whose corners are rounded, looking 2 metres ahead. The eye
/// never leaves the triangles of three points in a row, so where those are free it stands in no solid. A way that is
/// too short goes straight on at its end.
FlightPath<3> on_foot(std::string id, std::span<const Vec<2>> way, std::size_t frames);

/// "test": eight frames spread over the path.
FlightPath<3> test_path(const FlightPath<3>& path);

}  // namespace sightline
