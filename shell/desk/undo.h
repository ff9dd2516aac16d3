// Undo of what changes a session: scene, settings, views, notes and bookmarks, never steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// Call before a change. Changes of one gesture, e.g. a drag, share an entry; an empty name never joins.
template <int D>
void remember(Workbench<D>& bench, const std::string& gesture = "");

/// Ends the gesture: the next change of the same name makes a new entry.
template <int D>
void end_gesture(Workbench<D>& bench) {
    bench.history.gesture.clear();
}

/// False when there is nothing to undo or redo.
template <int D>
bool undo(Workbench<D>& bench);
template <int D>
bool redo(Workbench<D>& bench);

}  // namespace sightline
