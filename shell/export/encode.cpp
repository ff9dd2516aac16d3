// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/encode.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/process/run_program.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

std::string hex(Colour colour) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%02x%02x%02x", colour.r, colour.g, colour.b);
    return text.data();
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "sightline-XXXXXX").string();
    if (error || !mkdtemp(name.data()))
        throw WorkError("cannot make a temporary folder: " + (error ? error.message() : std::strerror(errno)));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
}

void encode_film(const fs::path& folder, const std::string& pictures, double frames_per_second, Colour background,
                 const std::string& file) {
    const bool gif = file.ends_with(".gif");
    // A GIF has 256 colours: the best ones for these pictures. Video codecs take even sides only.
    const std::string filter = gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                   : "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hex(background);
    std::vector<std::string> words{"ffmpeg", "-v",     "error", "-y",  "-framerate", number_text(frames_per_second),
                                   "-i",     pictures, "-vf",   filter};
    if (!gif) words.insert(words.end(), {"-pix_fmt", "yuv420p", "-movflags", "+faststart"});
    words.push_back(file);
    run_program(std::move(words), "ffmpeg", folder);
}

}  // namespace sightline
