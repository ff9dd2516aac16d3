// The parameters of methods that walk a tree of boxes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"

namespace sightline {

/// What is drawn before the first box is tested; own: what the method takes unless it is told otherwise.
enum class Occluders : std::uint8_t { own, none, previous, largest, plp };
template <>
inline constexpr auto words<Occluders> = std::to_array<std::string_view>({"own", "none", "previous", "largest", "plp"});

const ParameterRow& occluders_row();
const ParameterRow& occluder_share_row();
const ParameterRow& refresh_row();
const ParameterRow& opacity_row();
const ParameterRow& worth_row();

}  // namespace sightline
