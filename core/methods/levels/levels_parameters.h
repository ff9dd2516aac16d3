// The parameters of the method `levels`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"

namespace sightline {

const ParameterRow& pixel_error_row();
const ParameterRow& frame_ms_row();
const ParameterRow& vertex_ns_row();
const ParameterRow& pixel_ns_row();
const ParameterRow& cost_row();

}  // namespace sightline
