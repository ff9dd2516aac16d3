// A comparison as a page: what changed by scene and budget, and the frames that gained and lost most.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/compare.h"
#include "lab/wrong_pictures.h"

namespace sightline::lab {

/// One side: its name for people and the study that it comes from, for pictures and commands.
struct Side {
    std::string name;
    Study study;
};

/// The frames of one scene and path that B lost and gained most, in wrong pixels, as A and as B render them.
struct SideBySide {
    std::string title;
    FramePicture a, b;
};

/// For each 3D scene and path, of the pair whose wrong pixels changed most. A path that cannot be loaded any more is
/// left out.
std::vector<SideBySide> draw_side_by_side(const std::vector<Pair>& pairs, const Side& a, const Side& b,
                                          const std::filesystem::path& folder, LabGraphics& graphics);

/// Like "coverage 71.2 -> 75.0 (+3.8 ± 1.1)"; better, worse, or within the noise.
std::string change_text(const Change& change);

/// compare.html and compare.json. Throws WorkError.
void write_comparison(const std::vector<Pair>& pairs, const std::vector<SideBySide>& pictures, const Side& a,
                      const Side& b, const std::filesystem::path& folder);

}  // namespace sightline::lab
