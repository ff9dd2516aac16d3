// What every move and every change ends with, so that the rest of the bench follows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// After every move and every change of what is shown, each of which calls it: leaves the middle of a step and takes
/// the second session along.
template <int D>
void moved(Workbench<D>& bench);

/// Moves the right one along; part of moved(), and alone after changes of notes and selection, which leave the middle
/// of a step as it is. The right one gets the left one's new scene and view when both had the same scene.
template <int D>
void take_along(Workbench<D>& bench);

/// After every new traversal: counts it, and records the whole run where the bench asks for it.
template <int D>
void traversal_changed(Workbench<D>& bench);

/// The next frame of a flight: the culling view of both sessions moves, and both run to their budgets without a
/// recording. No entry for undo.
template <int D>
void fly_on(Workbench<D>& bench, const ViewSpec<D>& view);

/// All of the session's run; it stays where it is.
template <int D>
void record_whole_run(Session<D>& session);

}  // namespace sightline
