// Finished pieces of a long run on disk: a run that was stopped goes on where it was.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "lab/measure/results.h"

namespace sightline::lab {

/// A file of lines: what runs, then a line per piece, each written as soon as the piece is finished. A last line that
/// was cut is left out. Pieces that another build of the program, another machine or another renderer made are not
/// taken: they may differ.
class Checkpoint {
public:
    /// Reads what is there. Where program, machine or renderer differ the file is kept as FILE.old and a new one begun.
    /// Throws InputError when it belongs to another study, WorkError when it cannot be written.
    Checkpoint(std::filesystem::path file, const Conditions& conditions);

    /// The piece as it was added; nullptr when it is not finished.
    const std::string* find(const std::string& key) const;
    /// `piece` is JSON of one line. Throws WorkError, e.g. for a full disk.
    void add(const std::string& key, const std::string& piece);
    /// Whether pieces of other conditions were put aside.
    bool began_anew() const { return began_anew_; }

private:
    std::filesystem::path file_;
    std::ofstream out_;
    std::map<std::string, std::string> pieces_;
    bool began_anew_ = false;
};

}  // namespace sightline::lab
