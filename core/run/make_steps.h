// The loop of a run that goes step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/recorder.h"

namespace sightline {

/// Calls `next()`, which returns Stop::none for a step made, else why there is none, until `steps` more are made.
/// `made` and `counters` are the run's own, which next() changes: each step ends with them in the recording.
template <typename Next>
Stop make_steps(const std::uint32_t& made, std::uint32_t steps, const Counters& counters, Recorder* recorder,
                Next next) {
    const std::uint64_t end = std::uint64_t{made} + steps;
    while (made < end) {
        if (const Stop stop = next(); stop != Stop::none) return stop;
        if (recorder) recorder->finished(counters);
    }
    return Stop::steps;
}

}  // namespace sightline
