// The methods that walk the tree of boxes: view culling, and what engines use to cull by images.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

/// View culling, walked from the root (the gem's traditional algorithm).
template <int D>
Method<D> view_method();

/// boxes, hzb (Greene et al. 1993), hom (Zhang et al. 1997), two-pass. `picker` is what occluders=plp renders.
template <int D>
std::vector<Method<D>> image_methods(const Method<D>& picker);

}  // namespace sightline
