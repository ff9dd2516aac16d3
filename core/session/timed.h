// Adding up the time that work takes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/stopwatch.h"

namespace sightline {

/// Adds the time that `work` takes to `milliseconds`.
template <typename Work>
auto timed(double& milliseconds, Work work) {
    struct Clock {
        double& sum;
        Stopwatch stopwatch;
        ~Clock() { sum += stopwatch.milliseconds(); }
    } clock{milliseconds, {}};
    return work();
}

}  // namespace sightline
