// Pictures into a GIF or a video, by the program ffmpeg.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/draw/draw_list.h"

namespace sightline {

/// A folder of its own that is removed with all that lies in it; those that killed processes left where it is made are
/// removed, too.
class TemporaryFolder {
public:
    /// In the folder `where`; empty: among the system's temporary files. Throws WorkError.
    explicit TemporaryFolder(const std::filesystem::path& where = {});
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int lock_ = -1;  ///< held on the folder while this process lives
};

/// `pictures` is a pattern in `folder` such as "frame-%04d.png", counted from 1; `file` is made there, and its ending,
/// .gif or .mp4, chooses the format. Videos get a column or a row of the background where the pictures' sides are odd.
/// Throws WorkError when ffmpeg is not installed or fails.
void encode_film(const std::filesystem::path& folder, const std::string& pictures, double frames_per_second,
                 Colour background, const std::string& file);

}  // namespace sightline
