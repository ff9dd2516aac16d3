// Playing and pausing, by the clock (transport.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

template <int D>
TransportState transport_state(const Workbench<D>& bench);

/// Starts to play; from the start again where the run is finished.
template <int D>
void play(Workbench<D>& bench);
template <int D>
void pause(Workbench<D>& bench);

/// Sets the speed so that the whole run takes this long.
template <int D>
void play_whole_run_in(Workbench<D>& bench, double seconds);

/// Makes the steps that are due after this much time. Stops at breakpoints, at the budget and at the empty front.
template <int D>
void advance_clock(Workbench<D>& bench, double seconds);

}  // namespace sightline
