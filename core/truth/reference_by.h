// Who draws references in 3D: a setting.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/words.h"

namespace sightline {

enum class ReferenceBy : std::uint8_t { opengl, software };
template <>
inline constexpr auto words<ReferenceBy> = std::to_array<std::string_view>({"opengl", "software"});

}  // namespace sightline
