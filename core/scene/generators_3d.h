// The generated 3D scenes. Every function returns the same bits on every machine for the same seed and size; lengths
// are metres, z is up, the ground is at z = 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/catalogue.h"

namespace sightline::generate {

/// Furnished houses between streets. A larger city has more of the same: what stands near the origin stays, bit for
/// bit. Paths "street" (stays near the origin whatever the size) and "air".
Generated city(std::uint64_t seed, std::size_t triangles);

}  // namespace sightline::generate
