// The insets of a picture in 3D: what the culling view sees at this very step, and which of its pixels are missed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// Those that the setting `inset` asks for, from above, of the aspect of the reference; asks for the reference where
/// missed pixels are among them (TVCG fig. 14).
std::vector<Figure::Inset> make_insets(const Session<3>& session);

}  // namespace sightline
