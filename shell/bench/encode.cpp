// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/encode.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/error.h"
#include "core/file.h"
#include "core/number.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

/// Where a program that is started reads and writes.
class Redirections {
public:
    Redirections(const char* in, const char* out, const char* errors) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, in, O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, out, O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

/// Runs a program without a shell and waits for it; its exit status, or -1 when it was ended otherwise. Throws
/// WorkError when it cannot be started.
int run_program(std::vector<std::string> words, const fs::path& errors) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const Redirections redirections("/dev/null", "/dev/null", errors.c_str());
    pid_t child = 0;
    if (const int why = posix_spawnp(&child, words[0].c_str(), redirections.get(), nullptr, arguments.data(), environ))
        throw WorkError(why == ENOENT
                            ? "the program " + words[0] + " is needed for this: install the package " + words[0]
                            : "cannot start " + words[0] + ": " + std::strerror(why));
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw WorkError("cannot wait for " + words[0] + ": " + std::strerror(errno));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

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

void encode_film(const fs::path& pictures, double frames_per_second, Colour background, const fs::path& file) {
    const bool gif = file.extension() == ".gif";
    // A GIF has 256 colours: the best ones for these pictures. Video codecs take even sides only.
    const std::string filter = gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                   : "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hex(background);
    std::vector<std::string> words{
        "ffmpeg",          "-v",  "error", "-y", "-framerate", number_text(frames_per_second), "-i",
        pictures.string(), "-vf", filter};
    if (!gif) words.insert(words.end(), {"-pix_fmt", "yuv420p", "-movflags", "+faststart"});
    words.push_back(file.string());
    const fs::path errors = file.string() + ".errors";
    if (run_program(words, errors) == 0) return;
    std::string why = read_file(errors);
    why = why.substr(0, why.find('\n'));
    throw WorkError("ffmpeg failed: " + (why.empty() ? "it does not say why" : why));
}

}  // namespace sightline
