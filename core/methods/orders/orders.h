// The orders of primitives that other methods are compared with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/orders/order_run.h"

namespace sightline {

/// Draws all, culls nothing.
template <int D>
PrimitiveOrder<D> scene_order();
/// Nearest centroid first (TVCG 4.5); equal distances by id.
template <int D>
PrimitiveOrder<D> centroid_order();
/// The visible primitives, nearest centroid first: what no method can do better. Asks for the exact visible set; throws
/// WorkError where there is none to be had.
template <int D>
PrimitiveOrder<D> perfect_order();

}  // namespace sightline
