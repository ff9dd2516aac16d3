// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace sightline {

namespace {

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) throw WorkError(std::string("cannot make a pipe: ") + std::strerror(errno));
    }
    ~Pipe() {
        close_write();
        close(ends[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_write() {
        if (ends[1] >= 0) close(ends[1]);
        ends[1] = -1;
    }
};

/// Where a program that is started stands, reads and writes.
class Redirections {
public:
    Redirections(int errors, const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> part;
    for (ssize_t n; (n = read(descriptor, part.data(), part.size())) != 0;) {
        if (n < 0 && errno != EINTR) break;
        if (n > 0) text.append(part.data(), static_cast<std::size_t>(n));
    }
    return text;
}

}  // namespace

void run_program(std::vector<std::string> words, const std::string& package, const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    Pipe errors;
    const Redirections redirections(errors.ends[1], folder);
    pid_t child = 0;
    if (const int why = posix_spawnp(&child, words[0].c_str(), redirections.get(), nullptr, arguments.data(), environ))
        throw WorkError(why == ENOENT
                            ? "the program " + words[0] + " is needed for this: install the package " + package
                            : "cannot start " + words[0] + ": " + std::strerror(why));
    errors.close_write();
    const std::string complaint = read_all(errors.ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw WorkError("cannot wait for " + words[0] + ": " + std::strerror(errno));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    const std::size_t start = std::min(complaint.find_first_not_of(" \n"), complaint.size());
    const std::string line = complaint.substr(start, complaint.find('\n', start) - start);
    throw WorkError(words[0] + " failed: " + (line.empty() ? "it does not say why" : line));
}

}  // namespace sightline
