// Undo of what changes a session: scene, settings, views, notes and bookmarks, never steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

template <int D>
struct Workbench;

/// What undo brings back.
template <int D>
struct Snapshot {
    std::shared_ptr<const Scene<D>> scene;
    Settings settings;
    ViewSpec<D> culling_view, display_view;
    Frozen frozen = Frozen::nothing;
    std::vector<Note<D>> notes;
    std::vector<Bookmark> bookmarks;
    std::uint32_t selected_primitive = none;  ///< brought back with another scene only, whose numbers it means
};

template <int D>
struct History {
    std::vector<Snapshot<D>> past, future;
    std::string gesture;  ///< what made the last entry of `past`; empty when nothing may join it
};

/// Most entries that History keeps.
inline constexpr std::size_t history_limit = 200;

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
