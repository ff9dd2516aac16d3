// The one driver: steps until the budget, the end, a number of steps or a condition ends it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/stopwatch.h"
#include "core/run/budget.h"
#include "core/run/run.h"

namespace sightline {

/// Calls `step()`, which returns Stop::none for a step made, at most `steps` times; after each `holds()` may end it
/// (Stop::breakpoint). A budget in milliseconds ends it after the step that uses it up (Stop::budget).
template <typename MakeStep, typename Holds>
Stop drive(const Budget& budget, std::uint32_t steps, MakeStep step, Holds holds) {
    const Stopwatch running;
    for (std::uint32_t made = 0; made < steps; ++made) {
        if (const Stop stop = step(); stop != Stop::none) return stop;
        if (holds()) return Stop::breakpoint;
        if (budget.kind == Budget::Kind::milliseconds && running.milliseconds() >= budget.value) return Stop::budget;
    }
    return Stop::steps;
}

/// A run to its end or that of the budget, unrecorded.
template <int D>
Stop drive(const Budget& budget, Run<D>& run) {
    if (budget.kind != Budget::Kind::milliseconds) return run.run(none);
    return drive(
        budget, none,
        [&] {
            const Stop stop = run.run(1);
            return stop == Stop::steps ? Stop::none : stop;
        },
        [] { return false; });
}

}  // namespace sightline
