// Switching between a method of cells and cPLP, which completes its picture, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// The run goes on from where it stands in the rounds of cPLP, to their end: the method becomes cPLP with this one
/// first, and the budget what is spent so far. From cPLP back: its first method goes on alone, with the budget that it
/// had before where `complete` changed it, at the step where the rounds began. Throws InputError for a method that
/// orders no cells.
template <int D>
void complete(Workbench<D>& bench);

}  // namespace sightline
