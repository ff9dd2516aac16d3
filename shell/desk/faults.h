// What the whole run misses, kept as long as the traversal and its reference stay.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// Those that are kept, where they are of this run; else nullptr.
template <int D>
const Faults* faults(const Workbench<D>& bench);

/// Makes them where the truth is told and they are not there; `with_objects`: those of the objects too. True when
/// something was made now. Cost: the run to its end, the reference, and an image of the scene for the objects.
template <int D>
bool update_faults(Workbench<D>& bench, bool with_objects = false);

/// To the end of the run, with the triangle or segment selected that owns most of the pixels of a wrong region, from
/// 1: the largest. Throws InputError where there is no such region.
template <int D>
void hunt(Workbench<D>& bench, std::uint32_t region);

}  // namespace sightline
