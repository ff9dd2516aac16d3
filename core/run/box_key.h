// What the key of a box that comes by its distance is made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/run/explanation.h"

namespace sightline {

/// "key = distance² = 8.99² = 80.8". With the size of the largest primitive in it:
/// "key = distance² / √size = 8.99² / √0.25 = 162".
KeyExplanation explain_box_key(double squared_distance, std::optional<double> largest, int digits);

}  // namespace sightline
