// Taking back a gesture in its middle: a drag that Escape ends leaves no trace.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// The bench as it was when the gesture began.
template <int D>
struct Gesture {
    Session<D> session;
    History<D> history;
    std::vector<std::uint32_t> marked;
    std::string marked_by;
};

/// Changes that are made from now on under one gesture name share an entry of the history.
template <int D>
Gesture<D> begin_gesture(Workbench<D>& bench);

/// Puts the bench back, its history and its place in the run included.
template <int D>
void cancel_gesture(Workbench<D>& bench, Gesture<D> gesture);

}  // namespace sightline
