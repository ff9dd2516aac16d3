// Switching between a method of cells and cPLP, which completes its picture, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// In flight: whether the picture is completed wherever the eye rests (complete_at_rest). Else the run goes on from
/// where it stands in the rounds of cPLP, to their end: the method becomes cPLP with this one first, and the budget
/// what is spent so far. From cPLP back: its first method goes on alone, with the budget that it had before where
/// `complete` changed it, at the step where the rounds began. Throws InputError for a method that orders no cells.
template <int D>
void complete(Workbench<D>& bench);

/// Where the eye rests in flight: if pictures are to be completed, the rounds of cPLP go on where the method's budget
/// ended, to their end. True when there was something to do.
template <int D>
bool complete_at_rest(Workbench<D>& bench);

/// Before the eye moves on: the method that flew here is alone again. The frame is not flown anew.
template <int D>
void fly_alone(Workbench<D>& bench);

}  // namespace sightline
