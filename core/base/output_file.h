// A file that appears under its name when it is complete, or not at all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace sightline {

/// Writes beside the target and renames. Without commit() the temporary file is removed and the target is untouched.
/// A link is followed; a pipe or a device is written to directly.
class OutputFile {
public:
    /// Throws WorkError with path and reason when the file cannot be made.
    explicit OutputFile(std::filesystem::path target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends. Throws WorkError, e.g. for a full disk.
    void write(std::string_view data);
    /// Puts the file under its name. Throws WorkError.
    void commit();

private:
    std::filesystem::path target_, temporary_;
    int descriptor_ = -1;
};

}  // namespace sightline
