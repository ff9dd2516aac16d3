// A comparison as a page: what changed by scene and budget, and the frames that gained and lost most.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/compare/compare.h"
#include "lab/report/wrong_pictures.h"

namespace sightline::lab {

/// One side: its name for people and the study that it comes from, for pictures and commands.
struct Side {
    std::string name;
    Study study;
    Conditions conditions;
};

struct Comparison {
    Side a, b;
    bool two_runs = false;  ///< not two methods of one run
    std::vector<Pair> pairs;
};

/// The frames of one scene and path that B lost and gained most, in wrong pixels, as A and as B render them.
struct SideBySide {
    std::string title;
    FramePicture a, b;
};

/// For each scene and path, of the pair whose wrong pixels changed most. Throws InputError for a scene that is not
/// here.
std::vector<SideBySide> draw_side_by_side(const Comparison& comparison, const std::filesystem::path& folder,
                                          LabGraphics& graphics);

/// "city, path street, published at 5%"; both methods where they are two.
std::string pair_title(const Pair& pair);

/// Like "coverage 71.2 -> 75.0 (+3.8 ± 1.1)"; better, worse, or within the noise.
std::string change_text(const Change& change);

/// What to know before one believes it, a sentence each: other builds or machines, what times are held against, how
/// many numbers changed and how many of them chance alone would make look so.
std::vector<std::string> notes_of(const Comparison& comparison);

/// compare.html and compare.json. Throws WorkError.
void write_comparison(const Comparison& comparison, const std::vector<SideBySide>& pictures,
                      const std::filesystem::path& folder);

}  // namespace sightline::lab
