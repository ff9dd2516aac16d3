// Two sessions beside each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sightline {

enum class Side : std::uint8_t { neither, both, left, right };

enum class Align : std::uint8_t { step, rendered };

}  // namespace sightline
