// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/output_file.h"

#include <fcntl.h>
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
    if (std::filesystem::is_symlink(target_, error)) {
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
    // Short, whatever the target's own name: file systems limit a name's length.
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        temporary_ = folder / (".sightline-" + std::to_string(getpid()) + "-" + std::to_string(attempt) + ".tmp");
        descriptor_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) fail(target_, words_of(errno));
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
    if (close(std::exchange(descriptor_, -1)) != 0) fail(target_, words_of(errno));
    if (temporary_.empty()) return;
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail(target_, words_of(errno));
    temporary_.clear();
}

}  // namespace sightline
