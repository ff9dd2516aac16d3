// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/start/terminal_progress.h"

#include <unistd.h>

#include <iostream>
#include <memory>

#include "core/base/stopwatch.h"

namespace sightline {

Progress terminal_progress() {
    if (isatty(STDERR_FILENO) == 0) return {};
    constexpr double silent_ms = 500;
    const auto since = std::make_shared<Stopwatch>();
    return [since](std::string_view what, double share) {
        if (since->milliseconds() < silent_ms) return;
        const bool done = share >= 1;
        std::cerr << "\r" << what << ": " << static_cast<int>(100 * share) << " %   " << (done ? "\n" : "")
                  << std::flush;
    };
}

}  // namespace sightline
