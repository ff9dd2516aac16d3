// The one driver: steps until the budget, the end, a number of steps or a condition ends it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/stopwatch.h"
#include "core/run/budget.h"
#include "core/run/frame_cost.h"
#include "core/run/run.h"

namespace sightline {

/// Calls `step()`, which returns Stop::none for a step made, at most `steps` times; after each `holds()` may end it
/// (Stop::breakpoint). A budget in milliseconds is that of the whole frame: it ends the run (Stop::budget) where
/// another step like the last one would leave too little for `cost`, which follows the run, once `rendered()`
/// primitives are there. `clock()`: milliseconds since the frame began.
template <typename MakeStep, typename Holds, typename Rendered, typename Clock>
Stop drive(const Budget& budget, const FrameCost& cost, std::uint32_t steps, MakeStep step, Holds holds,
           Rendered rendered, Clock clock) {
    const bool timed = budget.kind == Budget::Kind::milliseconds;
    double before = timed ? clock() : 0;
    std::uint32_t rendered_before = timed ? rendered() : 0;
    for (std::uint32_t made = 0; made < steps; ++made) {
        if (const Stop stop = step(); stop != Stop::none) return stop;
        if (holds()) return Stop::breakpoint;
        if (!timed) continue;
        const double now = clock();
        const std::uint32_t drawn = rendered();
        const double next = now - before + cost.per_primitive_ms * (drawn - rendered_before);
        if (traversal_ms_left(budget.value, now, cost, drawn) <= next) return Stop::budget;
        before = now;
        rendered_before = drawn;
    }
    return Stop::steps;
}

/// A run to its end or that of the budget, unrecorded.
template <int D>
Stop drive(const Budget& budget, Run<D>& run, const FrameCost& cost = {}, const Stopwatch& frame = {}) {
    if (budget.kind != Budget::Kind::milliseconds) return run.run(none);
    return drive(
        budget, cost, none,
        [&] {
            const Stop stop = run.run(1);
            return stop == Stop::steps ? Stop::none : stop;
        },
        [] { return false; }, [&] { return run.counters().drawn(); }, [&] { return frame.milliseconds(); });
}

}  // namespace sightline
