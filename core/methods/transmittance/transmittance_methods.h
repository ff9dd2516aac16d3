// The rows of the methods that follow light from the eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

/// flux, tri and tri-seen.
template <int D>
std::vector<Method<D>> transmittance_methods();

}  // namespace sightline
