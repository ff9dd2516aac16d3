// What the culling eye sees, as pictures in pictures: so far, of everything, and which pixels it misses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/solid_list.h"
#include "core/session/session.h"

namespace sightline {

inline constexpr const char* title_of_image = "the culling eye, so far";
inline constexpr const char* title_of_exact = "the exact image";
inline constexpr const char* title_of_missed = "wrong pixels in red";

/// What is rendered so far.
SolidList image_so_far(const Session<3>& session);

/// What there is to see; asks for the reference.
SolidList exact_image(const Session<3>& session);

bool shows_depth(const Settings& settings);
/// Of the inset of depth_picture, with its text.
std::string depth_title(const Settings& settings, const std::string& text);

/// Those that the setting `inset` asks for, from above, of the aspect of the reference, which is asked for where they
/// need it (TVCG fig. 14); then the plan of a method that chooses by viewpoint.
std::vector<Figure::Inset> make_insets(const Session<3>& session);

}  // namespace sightline
