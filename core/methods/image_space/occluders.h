// What is drawn first, so that boxes can be hidden by it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/image_space/image_parameters.h"
#include "core/run/run.h"

namespace sightline {

/// The occluders in view, in the order in which they are drawn. largest: of the share occluder_share of the primitives
/// the largest by their area-angle |A cos| / r² (Coorg and Teller 1997, section 4; in 2D length · cos / r), largest
/// first. plp: what `picker` starts renders with that budget, in its order. previous: what the last frame's history
/// says was visible, by id; none without one.
template <int D>
std::vector<std::uint32_t> occluders(const Problem<D>& problem, Occluders which,
                                     const std::function<std::unique_ptr<Run<D>>(const Problem<D>&)>& picker);

}  // namespace sightline
