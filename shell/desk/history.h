// What undo brings back of a session: scene, settings, views, notes and bookmarks, never steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

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

}  // namespace sightline
