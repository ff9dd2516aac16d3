// Finished pieces of a long run on disk: a run that was stopped goes on where it was.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lab/measure/results.h"

namespace sightline::lab {

/// A file of lines: what runs, then a line per piece, each written as soon as the piece is finished. Every line begins
/// with a hash of the rest: one that was cut or damaged is named and left out, so that its piece is made again. Pieces
/// that another build of the program, another machine or another renderer made are not taken: they may differ.
class Checkpoint {
public:
    /// Reads what is there. Where program, machine or renderer differ, or what runs cannot be read, the file is kept as
    /// FILE.old and a new one begun. Throws InputError when it belongs to another study, WorkError when it cannot be
    /// written.
    Checkpoint(std::filesystem::path file, const Conditions& conditions);

    /// The piece as it was added; nullptr when it is not finished.
    const std::string* find(const std::string& key) const;
    /// `piece` is JSON of one line. Throws WorkError, e.g. for a full disk.
    void add(const std::string& key, const std::string& piece);
    /// Whether pieces of other conditions were put aside.
    bool began_anew() const { return began_anew_; }
    /// What was damaged: file, line and reason, a sentence each.
    const std::vector<std::string>& damages() const { return damages_; }

private:
    std::filesystem::path file_;
    std::ofstream out_;
    std::map<std::string, std::string> pieces_;
    std::vector<std::string> damages_;
    bool began_anew_ = false;
};

/// A line of such a file from an object of JSON, on one line, that is not empty.
std::string checkpoint_line(const std::string& object);
/// The study that such a file belongs to; nothing where that cannot be read.
std::optional<std::string> checkpoint_study(const std::filesystem::path& file);

}  // namespace sightline::lab
