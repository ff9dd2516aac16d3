// What an eye in the plane has before it so far: a strip of depths under the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/draw/draw_list.h"
#include "core/draw/palette.h"
#include "core/raster/pixel_line.h"
#include "core/session/session.h"

namespace sightline {

/// What is drawn at the session's position: a line of pixels as wide as the reference.
PixelLine line_so_far(const Session<2>& session);
/// The same as the picture that the method decides by has it: where that is a small one of its own, as wide as that,
/// and with what is drawn there ahead of its turn.
PixelLine line_that_decides(const Session<2>& session);

/// How far up from the lower border of a picture the strip and its marks reach, as a share of the height.
inline constexpr double depth_strip_top = 0.065;

/// Along the lower border of the list's world, from the left of the view to its right: the nearer what is rendered, the
/// darker, and empty where nothing is. Above it a bar marks the pixels of the selected cell or primitive, else of
/// the last step's box or cell, as they would be seen or are hidden; a label says how many. Depths are those of
/// line_that_decides(); the label says where that is a small picture. Where the strip of what the eye sees is shown
/// too, it stands over this one, place over place.
void add_depth_strip(const Session<2>& session, const Colours& colours, DrawList& list);

/// " behind segments 7, 9": some of them, and how many more. Empty for none.
std::string behind_text(std::string_view one, std::span<const std::uint32_t> hidden_by);

}  // namespace sightline
