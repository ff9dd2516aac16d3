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

struct EyeStrip;  // core/draw/eye_strip.h

/// A picture as three lists that lie on one another: a window draws the middle one, which no step changes, only once.
enum class PicturePart : std::uint8_t {
    all,
    below,         ///< the cells' fills
    tessellation,  ///< the cells' borders
    above,         ///< the rest, with all labels
};

struct PictureOptions {
    /// What the lowest and the highest colour of the heat map stand for (number_range; panels of one figure share it).
    std::optional<std::array<double, 2>> heat_range{};
    /// The part of the scene to show; nothing: what the settings say (shown_world.h).
    std::optional<Box<2>> world{};
    /// > 0: the world is widened, never cut, to this width / height, so that all of a window is drawn and labelled.
    double aspect = 0;
    /// Per cell, for two sessions beside each other (cell_differences): marked over the picture. Empty: none.
    std::span<const Differs> differences{};
    PicturePart part = PicturePart::all;
    /// A facet to point out, by its place among those of the last cell: where a substep looks across.
    std::optional<std::uint32_t> facet{};
    /// What the eye sees of this session, where it is at hand already; else it is made when a setting asks for it.
    const EyeStrip* eye = nullptr;
    /// Where a class has to find the number of this cell: its label is a question mark.
    std::optional<std::uint32_t> concealed{};
    bool choice = true;  ///< show_choice may show what the last step chose
};

/// The picture that the session's picture settings ask for.
DrawList make_picture(const Session<2>& session, const PictureOptions& options = {});

}  // namespace sightline
