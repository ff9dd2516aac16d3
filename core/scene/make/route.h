// Inside core/scene: flight paths out of way points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/scene/flight_path.h"

namespace sightline {

/// An eye that goes from the first to the last point in equal steps and looks at where it will be `ahead` metres
/// later; beyond the last point it looks straight on. At least two points, no two in a row the same.
FlightPath<3> along(std::string id, std::span<const Vec<3>> points, std::size_t frames, double ahead, double fov);

/// "test": eight frames spread over the path.
FlightPath<3> test_path(const FlightPath<3>& path);

}  // namespace sightline
