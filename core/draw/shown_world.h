// Which part of the scene a picture shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

namespace sightline {

/// What the picture settings zoom, zoom_at, zoom_x and zoom_y show.
Box<2> shown_world(const Session<2>& session);

/// The same with the notes that a window, being wider, shows beside it.
Box<2> figure_world(const Session<2>& session);

/// `aspect` > 0: the box widened, never cut, to this width / height, about the same middle.
Box<2> widened(Box<2> box, double aspect);

}  // namespace sightline
