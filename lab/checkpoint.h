// Finished frames of a study on disk: a run that was stopped goes on where it was.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>

#include "lab/measure_path.h"

namespace sightline::lab {

/// A file of lines: the study, then a line per frame, each written as soon as the frame is finished. A last line that
/// was cut is left out.
class Checkpoint {
public:
    /// Reads what is there. Throws InputError when the file belongs to another study, WorkError when it cannot be
    /// written.
    Checkpoint(std::filesystem::path file, const std::string& study);

    const FrameResult* find(const std::string& scene, const std::string& path, std::uint32_t frame) const;
    /// Throws WorkError, e.g. for a full disk.
    void add(const std::string& scene, const std::string& path, const FrameResult& result);
    std::size_t size() const { return finished_.size(); }

private:
    std::filesystem::path file_;
    std::ofstream out_;
    std::map<std::tuple<std::string, std::string, std::uint32_t>, FrameResult> finished_;
};

}  // namespace sightline::lab
