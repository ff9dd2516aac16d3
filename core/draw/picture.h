// A session as a picture, and pictures as a figure: state and settings in, draw lists out. Nothing here moves a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// The picture that the session's picture settings ask for. `heat_range`: what the lowest and the highest colour of
/// the heat map stand for (number_range; panels of one figure share it).
DrawList make_picture(const Session<2>& session, const std::optional<std::array<double, 2>>& heat_range);

struct PanelSource {
    Session<2> session;
    std::string title;  ///< e.g. "step 12"; panels of one figure get (a), (b), … before it
};

/// One figure of all panels with one legend and one scale; palette, legend and caption as in the first panel.
Figure make_figure(std::span<const PanelSource> panels);

}  // namespace sightline
