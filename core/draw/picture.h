// A session as a picture: state and settings in, a draw list out. Nothing here moves a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// The picture that the session's picture settings ask for. `heat_range`: what the lowest and the highest colour of
/// the heat map stand for (number_range; panels of one figure share it).
DrawList make_picture(const Session<2>& session, const std::optional<std::array<double, 2>>& heat_range);

}  // namespace sightline
