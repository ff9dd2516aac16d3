// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/say.h"

#include <unistd.h>

#include <csignal>
#include <iostream>

#include "core/base/text.h"

namespace sightline::lab {

namespace {

volatile std::sig_atomic_t seen = 0;  // a signal handler can reach nothing else

}  // namespace

void say(const std::string& text) {
    const std::string line = one_line(text, 1000);
    if (isatty(STDERR_FILENO))
        std::cerr << "\r\033[K" << line << std::flush;
    else if (!line.empty())
        std::cerr << line << "\n";
}

void warn(const std::string& text) {
    if (isatty(STDERR_FILENO)) say("");
    std::cerr << "lab: warning: " << one_line(text, 1000) << "\n";
}

void note_interrupts() {
    std::signal(SIGINT, [](int) { seen = 1; });
    std::signal(SIGTERM, [](int) { seen = 1; });
}

bool interrupted() { return seen != 0; }

int stopped() {
    say("");
    std::cerr << "lab: stopped; run the same command again to continue\n";
    return 1;
}

}  // namespace sightline::lab
