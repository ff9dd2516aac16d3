// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "core/base/error.h"

namespace sightline {

namespace {

constexpr int ended_well = 0, out_of_memory = 3, failed = 4;

/// Best effort. Where the system tells by signal, that comes at `most` and the end a little later.
void limit(__rlimit_resource_t resource, double most, double grace = 0) {
    const rlimit limits{static_cast<rlim_t>(most), static_cast<rlim_t>(most + grace)};
    setrlimit(resource, &limits);
}

void limit_memory(double more) {
    double pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    limit(RLIMIT_AS, pages * static_cast<double>(sysconf(_SC_PAGESIZE)) + more);
}

void send_all(int to, const void* bytes, std::size_t size) {
    for (const char* at = static_cast<const char*>(bytes); size > 0;) {
        const ssize_t sent = write(to, at, size);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(failed);
        at += sent;
        size -= static_cast<std::size_t>(sent);
    }
}

[[noreturn]] void be_the_child(const std::function<void(const ChildProcess::Send&)>& work, int to, double seconds,
                               double bytes) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int fatal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE, SIGTERM, SIGINT})
        signal(fatal, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds, 2);
    limit_memory(bytes);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    int status = failed;
    try {
        work([to](const void* bytes, std::size_t size) { send_all(to, bytes, size); });
        status = ended_well;
    } catch (const std::bad_alloc&) {
        status = out_of_memory;
    } catch (...) {
    }
    _exit(status);  // what this process is a copy of must not be torn down twice
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(const Send&)>& work, double seconds, double bytes)
    : most_waiting_(4 * seconds) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw WorkError(std::string("cannot create a pipe: ") + std::strerror(errno));
    process_ = fork();
    if (process_ == 0) {
        close(ends[0]);
        be_the_child(work, ends[1], seconds, bytes);
    }
    const int error = errno;
    close(ends[1]);
    from_child_ = ends[0];
    if (process_ < 0) {
        close(from_child_);
        throw WorkError(std::string("cannot start a process: ") + std::strerror(error));
    }
    fcntl(from_child_, F_SETPIPE_SZ, 1 << 20);  // best effort
}

ChildProcess::~ChildProcess() {
    close(from_child_);
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool ChildProcess::read(void* bytes, std::size_t size, const std::function<void()>& tick) {
    for (char* at = static_cast<char*>(bytes); size > 0;) {
        pollfd ready{from_child_, POLLIN, 0};
        constexpr int milliseconds = 100;
        const int events = poll(&ready, 1, milliseconds);
        if (events == 0) {
            waited_ += milliseconds / 1000.0;
            if (waited_ > most_waiting_) return false;
            tick();
        }
        if (events <= 0) continue;
        const ssize_t got = ::read(from_child_, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

std::string ChildProcess::end() {
    int status = 0;
    const bool too_long = waited_ > most_waiting_;
    if (too_long) kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (too_long) return "did not finish in time";
    if (WIFSIGNALED(status)) {
        if (WTERMSIG(status) == SIGXCPU) return "did not finish in time";
        return WTERMSIG(status) == SIGKILL ? "was killed (too little memory?)"
                                           : std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
    }
    if (WEXITSTATUS(status) == out_of_memory) return "ran out of memory";
    return WEXITSTATUS(status) == ended_well ? "" : "failed";
}

}  // namespace sightline
