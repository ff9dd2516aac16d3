// The methods that cull in object space: coorg-teller (Coorg and Teller 1996), shadow-frusta (Hudson et al. 1997).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

template <int D>
std::vector<Method<D>> object_space_methods();

}  // namespace sightline
