// The one constant for "no index": no cell, no primitive, no neighbour, no limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sightline {

inline constexpr std::uint32_t none = 0xffffffffu;

}  // namespace sightline
