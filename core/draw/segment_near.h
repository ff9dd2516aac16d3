// Which segment lies under a finger.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/scene/scene.h"

namespace sightline {

/// The segment nearest to a point, within reach of it (scene units); none when there is none. Cost: segments.
std::uint32_t segment_near(std::span<const Primitive<2>> segments, const Vec<2>& at, double reach);

}  // namespace sightline
