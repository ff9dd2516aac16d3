// Moves along the run. Each leaves in Workbench::last_stop why it ended.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/condition.h"
#include "shell/desk/workbench.h"

namespace sightline {

/// Stop::steps when all were made. In the middle of a step the first one completes that step.
template <int D>
void step_forward(Workbench<D>& bench, std::uint32_t steps);
template <int D>
void step_back(Workbench<D>& bench, std::uint32_t steps);

/// To a step; Stop::steps when it is there.
template <int D>
void go_to_step(Workbench<D>& bench, std::uint32_t step);

/// Forward to the budget or the end of the front.
template <int D>
void run_to_end(Workbench<D>& bench);

/// Forward, at least one step, until the condition holds after a step (Stop::breakpoint).
template <int D>
void run_until(Workbench<D>& bench, const Condition<D>& condition);

/// Forward, at least one and at most `steps` steps, until a breakpoint that is on holds (Stop::breakpoint). Throws
/// InputError for a condition that is none.
template <int D>
void run_to_breakpoint(Workbench<D>& bench, std::uint32_t steps = none);

/// The session at the end of its run, with all of it recorded.
template <int D>
Session<D> at_the_end(const Session<D>& session) {
    Session<D> end = session;
    end.run();
    return end;
}

/// The step that projects the cell, whether done or still to come; none when no step of the run does.
template <int D>
std::uint32_t step_of_cell(const Workbench<D>& bench, std::uint32_t cell);

/// Steps of the whole run, done and to come.
template <int D>
std::uint32_t whole_run(const Workbench<D>& bench);

}  // namespace sightline
