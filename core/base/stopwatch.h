// Wall-clock time since a moment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace sightline {

class Stopwatch {
public:
    /// Since this was made.
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace sightline
