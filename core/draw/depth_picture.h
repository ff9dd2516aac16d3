// Depths of what the culling eye has before it so far, and of blocks of pixels, as pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/draw/pixels.h"
#include "core/session/session.h"

namespace sightline {

struct DepthPicture {
    Pixels pixels;
    /// What is seen and hidden of what is marked, else how many tiles are read or pixels covered; short.
    std::string text;
};

/// What is rendered so far, at the size of the reference, or as the small picture has it that the method decides by,
/// which the text then says: the nearer the lighter, dark blue where nothing is. Blocks: each block of a level of the
/// hierarchical z pyramid, at most 64 blocks wide, is as dark as its farthest pixel. Pixels of the selected cell or
/// primitive, else of the last step's box or cell, are marked: green where it would be seen, blue where it is hidden.
/// Where rounds read the image by tiles, the tiles have borders, and those that the last round did not read are dimmed.
DepthPicture depth_picture(const Session<3>& session, bool blocks);

}  // namespace sightline
