// Inside core/scene: a car with its inside.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/car_parts.h"
#include "core/scene/make/model.h"

namespace sightline {

/// A car of 4.35 x 1.76 m on four wheels; its front is on x = 0, its middle line on y = 0. The body is a sheet with two
/// sides and openings for the windows; engine, seats and wheels are solids. `detail` from 1 on multiplies the number of
/// edges along and around; the engine is filled up with small parts until the model is full. `parts` is kept in step
/// with the model's triangles.
void car(Model& model, Random& random, int detail, bool hood_open, std::vector<CarPart>& parts);

/// Triangles of a body at detail 1, about.
inline constexpr std::size_t car_body_triangles = 1100;

}  // namespace sightline
