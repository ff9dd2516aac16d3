// Which axis of a model points up, where its file does not say.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/scene/reading.h"
#include "core/scene/scene.h"

namespace sightline {

struct UpGuess {
    int axis = 2;
    std::string why;  ///< "the model lies far from zero in x and y only"
};

/// For a model of a format without a rule, whose custom is `custom` (1 or 2): the other one of y and z where the
/// triangles speak for it. Nothing: they do not. Looked at are
///  - the origin that the model was moved by: far away in two axes and not in the third one is a place on a map;
///  - the ground: along an axis, the largest area at one height (to 1/128 of the extent) of the lower half that lies
///    flat and is seen from above, as a share of the footprint. It speaks for an axis that is not the longest extent
///    when it is at least half, and four times that of the custom one or the extent less than half of that one's: walls
///    of rooms are as large. A flat sheet has no up.
std::optional<UpGuess> guess_up(const Scene<3>& scene, int custom);

/// Sets the axis that a person asked for. `automatic`: guess_up(), unless it is `known` from the file, with a warning.
void turn_up(Scene<3>& scene, Up up, bool known);

}  // namespace sightline
