// A whole study: scene by scene, path by path, with progress, a checkpoint and a way to stop.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "lab/lab_graphics.h"
#include "lab/measure/results.h"

namespace sightline::lab {

/// Every n-th scene, path and error bound, from `index` on; the parts of a study on several machines or processes.
struct Shard {
    std::uint32_t index = 0, count = 1;
};
/// "2/5" is the second of five. Throws InputError.
Shard parse_shard(const std::string& text);

struct StudyRun {
    Shard shard{};
    std::function<void(const std::string& line)> say{};  ///< progress for people, one line at a time
    std::function<bool()> stopped{};                     ///< asked after each frame
};

/// Reads every scene and looks for its paths, so that what does not exist is said at once, not after hours.
void check_scenes(const Study& study, const std::function<void(const std::string& line)>& say);

/// Frames go to folder/frames.jsonl as they are finished; those found there are not measured again. Where it is stopped
/// the rows of unfinished paths are left out. Throws InputError for a scene or setting that does not exist or a folder
/// that holds another study.
Results run_study(const Study& study, const std::filesystem::path& folder, LabGraphics& graphics,
                  const StudyRun& run = {});

}  // namespace sightline::lab
