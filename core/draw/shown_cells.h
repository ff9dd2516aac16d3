// Which cells a 3D picture shows, whatever they look like, so that one sees into the others.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/draw/solid_list.h"
#include "core/session/session.h"

namespace sightline {

/// Whether the picture is seen by another eye than the one that the traversal works for. From that eye itself cells
/// would hide what it sees: then no cells and no cone are drawn.
inline bool seen_from_outside(const Session<3>& session) { return session.display_view() != session.culling_view(); }

/// The plane of the settings slice and slice_at: x, y and z cut away what lies above that share of the scene's box;
/// view cuts away what is nearer to the display eye than that share of the way through the part of the box before it.
/// Takes time in proportion to the triangles.
std::optional<Slice> slice_of(const Session<3>& session);

/// Per cell, whether slice_of() and the settings only and around leave it in the picture: 1 or 0. A cell goes or stays
/// as a whole, by its centre. `around` counts facets from the selected cell, or else from the last one.
std::vector<std::uint8_t> shown_cells(const Session<3>& session, const std::optional<Slice>& slice);

}  // namespace sightline
