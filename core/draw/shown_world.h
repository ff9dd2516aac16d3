// Which part of the scene a picture shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

namespace sightline {

/// The cell that the session's last step projected; none at the start and for methods that order primitives.
std::uint32_t last_cell(const Session<2>& session);

/// What the picture settings zoom, zoom_at, zoom_x and zoom_y show.
Box<2> shown_world(const Session<2>& session);

/// The same with the notes that a window, being wider, shows beside it.
Box<2> figure_world(const Session<2>& session);

/// `aspect` > 0: the box widened, never cut, to this width / height, about the same middle.
Box<2> widened(Box<2> box, double aspect);

}  // namespace sightline
