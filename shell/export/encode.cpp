// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/encode.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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

constexpr std::string_view temporary_name = ".sightline-film-";

/// The folder with a lock on it; -1: somebody else has the lock, or it is not ours.
int locked(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    struct stat status {};
    if (descriptor >= 0 && fstat(descriptor, &status) == 0 && status.st_uid == geteuid() && status.st_nlink > 0 &&
        flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        return descriptor;
    if (descriptor >= 0) close(descriptor);
    return -1;
}

void remove_abandoned_folders(const fs::path& where) {
    std::error_code error;
    for (fs::directory_iterator at(where, error), end; !error && at != end; at.increment(error)) {
        if (!at->path().filename().string().starts_with(temporary_name)) continue;
        const int descriptor = locked(at->path());
        if (descriptor < 0) continue;
        std::error_code kept;
        fs::remove_all(at->path(), kept);
        close(descriptor);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder(const fs::path& where) {
    std::error_code error;
    const fs::path parent = where.empty() ? fs::temp_directory_path(error) : where;
    if (!error) remove_abandoned_folders(parent);
    // Again where somebody who looks for abandoned ones came before the lock.
    for (int attempt = 0; lock_ < 0 && attempt < 100; ++attempt) {
        std::string name = (parent / (std::string(temporary_name) + "XXXXXX")).string();
        if (error || !mkdtemp(name.data()))
            throw WorkError("cannot make a temporary folder" + (where.empty() ? "" : " in " + where.string()) + ": " +
                            (error ? error.message() : std::strerror(errno)));
        path_ = name;
        lock_ = locked(path_);
        if (lock_ < 0 && errno != EWOULDBLOCK && fs::exists(path_, error)) return;  // no locks here: nobody removes it
    }
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
    if (lock_ >= 0) close(lock_);
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
