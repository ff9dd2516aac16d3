// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/base/error.h"

namespace sightline {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw WorkError("cannot write " + path.string() + ": " + reason);
}

std::string words_of(int error) { return std::generic_category().message(error); }

constexpr std::string_view temporary_begin = ".sightline-", temporary_end = ".tmp";

/// Removes what killed processes left in the folder. Whoever writes holds a lock, which ends with the process: numbers
/// of processes are used again, and are others on another machine.
void remove_abandoned(const std::filesystem::path& folder) {
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (!name.starts_with(temporary_begin) || !name.ends_with(temporary_end)) continue;
        const int descriptor = open(at->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (descriptor < 0) continue;
        if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(at->path().c_str());
        close(descriptor);
    }
}

/// Whether the new file is ours: somebody who looks for abandoned ones may have come before the lock. Where there are
/// no locks nobody removes anything.
bool take(int descriptor) {
    struct stat status {};
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    return fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path target) : target_(std::move(target)) {
    std::error_code error;
    // A rename would replace a device, a pipe or a link, not write into it. Without O_NONBLOCK, opening a pipe that
    // nobody reads would wait for ever.
    if (std::filesystem::is_other(target_, error)) {
        descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        if (descriptor_ < 0) fail(target_, words_of(errno));
        fcntl(descriptor_, F_SETFL, fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
        return;
    }
    const bool is_link = std::filesystem::is_symlink(target_, error);
    if (error == std::errc::filename_too_long) fail(target_, words_of(error.value()));  // before anything is written
    if (is_link) {
        const std::filesystem::path behind = std::filesystem::canonical(target_, error);
        if (error) fail(target_, "the link leads nowhere");
        target_ = behind;
    }
    const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    if (!std::filesystem::exists(folder, error)) fail(target_, "there is no folder " + folder.string());
    if (!std::filesystem::is_directory(folder, error)) fail(target_, folder.string() + " is not a folder");
    if (std::filesystem::is_directory(target_, error)) fail(target_, "it is a folder");
    // A rename would replace a file that its owner has protected.
    if (std::filesystem::exists(target_, error) && access(target_.c_str(), W_OK) != 0) fail(target_, words_of(errno));
    remove_abandoned(folder);
    // Short, whatever the target's own name: file systems limit a name's length.
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        temporary_ = folder / (std::string(temporary_begin) + std::to_string(getpid()) + "-" + std::to_string(attempt) +
                               std::string(temporary_end));
        descriptor_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) fail(target_, words_of(errno));
        if (descriptor_ < 0 || take(descriptor_)) continue;
        unlink(temporary_.c_str());
        close(std::exchange(descriptor_, -1));
    }
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view data) {
    while (!data.empty()) {
        const ssize_t written = ::write(descriptor_, data.data(), data.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(target_, words_of(errno));
        data.remove_prefix(static_cast<std::size_t>(written));
    }
}

void OutputFile::commit() {
    // A disk that is written to later says at a close that it is full; the lock lasts until the last one.
    if (const int other = dup(descriptor_); other < 0 || close(other) != 0) fail(target_, words_of(errno));
    if (!temporary_.empty() && rename(temporary_.c_str(), target_.c_str()) != 0) fail(target_, words_of(errno));
    temporary_.clear();
    if (close(std::exchange(descriptor_, -1)) != 0) fail(target_, words_of(errno));
}

}  // namespace sightline
