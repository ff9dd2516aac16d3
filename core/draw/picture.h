// A session as a picture: state and settings in, a draw list out. Nothing here moves a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/draw/draw_list.h"
#include "core/session/comparison.h"
#include "core/session/session.h"

namespace sightline {

struct PictureOptions {
    /// What the lowest and the highest colour of the heat map stand for (number_range; panels of one figure share it).
    std::optional<std::array<double, 2>> heat_range{};
    /// The part of the scene to show; nothing: what the settings say (shown_world.h).
    std::optional<Box<2>> world{};
    /// > 0: the world is widened, never cut, to this width / height, so that all of a window is drawn and labelled.
    double aspect = 0;
    /// Per cell, for two sessions beside each other: filled by who projected it instead of by state. Empty: by state.
    std::span<const Side> sides{};
};

/// The picture that the session's picture settings ask for.
DrawList make_picture(const Session<2>& session, const PictureOptions& options = {});

}  // namespace sightline
