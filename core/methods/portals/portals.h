// The methods that see from room to room.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

/// portals (Luebke and Georges 1995) and pvs (Airey 1990, Teller and Séquin 1991).
template <int D>
std::vector<Method<D>> portal_methods();

}  // namespace sightline
