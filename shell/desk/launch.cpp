// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/launch.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "core/base/error.h"

extern char** environ;

namespace sightline {

void launch(const std::string& program, const std::string& argument) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    std::string path = (self.parent_path() / program).string(), first = argument;
    // Through a shell that ends at once, so that nobody has to wait for the viewer's end.
    std::string shell = "/bin/sh", option = "-c", script = "\"$0\" ${1:+\"$1\"} >/dev/null 2>&1 &";
    char* arguments[] = {shell.data(), option.data(), script.data(), path.data(), first.data(), nullptr};
    if (error || access(path.c_str(), X_OK) != 0) throw InputError("there is no program " + path);
    pid_t process = 0;
    if (const int failed = posix_spawn(&process, shell.c_str(), nullptr, nullptr, arguments, environ); failed != 0)
        throw WorkError(path + ": cannot be started: " + std::strerror(failed));
    waitpid(process, nullptr, 0);
}

}  // namespace sightline
