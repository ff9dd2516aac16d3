// Pops between two frames: what the picture shows or loses although the truth has not changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/session/session.h"

namespace sightline {

/// Marks of the primitives that are visible both from the culling view and from `before`, and that only one of the two
/// frames renders (measure `pop`, frame_change.h): those that appear at the step that renders them, those that vanish
/// at the last step, behind which they would come. The frame before runs under the same settings. By step. Costs that
/// frame and its reference.
template <int D>
std::vector<Marker> pop_markers(const Session<D>& session, const ViewSpec<D>& before);

}  // namespace sightline
