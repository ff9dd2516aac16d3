// Work that may break or devour memory, done in a process of its own (Linux).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <string>

namespace sightline {

/// A copy of this process that does one piece of work and sends bytes. Crashes, aborts and endless loops end it alone,
/// what it prints goes nowhere, and all its memory is free when it has ended. Destroying the object ends it.
class ChildProcess {
public:
    /// Sends bytes to read(); ends the child when nobody reads any more.
    using Send = std::function<void(const void* bytes, std::size_t size)>;

    /// Starts `work` at once. It must not touch threads, windows or files of this process, nor let exceptions escape.
    /// It may compute for `seconds`, let read() wait for four times that (it may itself wait, for a pipe, say, which
    /// takes no computing) and take `bytes` of memory; bad_alloc comes at that. Throws WorkError when there is no
    /// process to be had.
    ChildProcess(const std::function<void(const Send&)>& work, double seconds, double bytes);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    /// Waits for exactly `size` bytes, calling `tick` about ten times a second; false when the child ended before or
    /// lets wait too long.
    bool read(void* bytes, std::size_t size, const std::function<void()>& tick);

    /// Waits for the end; nothing when the work returned, else why it did not: "crashed (Aborted)".
    std::string end();

private:
    pid_t process_ = -1;
    int from_child_ = -1;
    double most_waiting_;  ///< seconds
    double waited_ = 0;
};

}  // namespace sightline
