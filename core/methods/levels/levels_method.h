// The row of the method `levels`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

template <int D>
Method<D> levels_method();

}  // namespace sightline
