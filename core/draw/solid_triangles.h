// The scene's triangles in a 3D picture, by what the traversal and the reference say of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/solid_list.h"
#include "core/session/session.h"

namespace sightline {

/// Adds the triangles that the setting `triangles` asks for, a run for each SolidLook that some of them have: those of
/// the last step apart, those that complete a picture too unless they are known to be hidden, the others by whether
/// they are rendered and, where `tell_visible`, by whether they are visible. Needs the session's reference for the
/// latter and for triangles = visible.
void add_triangles(const Session<3>& session, bool tell_visible, SolidList& list);

}  // namespace sightline
