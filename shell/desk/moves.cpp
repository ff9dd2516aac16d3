// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/moves.h"

#include <algorithm>

#include "shell/desk/moved.h"

namespace sightline {

template <int D>
void step_forward(Workbench<D>& bench, std::uint32_t steps) {
    bench.last_stop = bench.session.run(bench.substep && steps > 0 ? steps - 1 : steps);
    moved(bench);
}

template <int D>
void step_back(Workbench<D>& bench, std::uint32_t steps) {
    const std::uint32_t position = bench.session.position();
    go_to_step(bench, position - std::min(position, steps));
}

template <int D>
void go_to_step(Workbench<D>& bench, std::uint32_t step) {
    bench.last_stop = bench.session.seek(step);
    moved(bench);
}

template <int D>
void run_to_end(Workbench<D>& bench) {
    bench.last_stop = bench.session.run();
    moved(bench);
}

template <int D>
void run_until(Workbench<D>& bench, const Condition<D>& condition) {
    bench.last_stop = run_until(bench.session, condition);
    moved(bench);
}

template <int D>
void run_to_breakpoint(Workbench<D>& bench, std::uint32_t steps) {
    std::vector<Condition<D>> conditions;
    for (const Breakpoint& breakpoint : bench.session.breakpoints)
        if (const auto here = condition_here(bench.session, breakpoint.condition); breakpoint.on && here)
            conditions.push_back(*here);
    const std::uint32_t end = bench.session.position() + std::min(steps, none - bench.session.position());
    bench.last_stop = bench.session.run_until([&](const Session<D>& s) {
        return s.position() == end ||
               std::any_of(conditions.begin(), conditions.end(), [&](const Condition<D>& c) { return c.holds(s); });
    });
    const bool hit = std::any_of(conditions.begin(), conditions.end(),
                                 [&](const Condition<D>& c) { return c.holds(bench.session); });
    if (bench.last_stop == Stop::breakpoint && !hit) bench.last_stop = Stop::steps;
    moved(bench);
}

template <int D>
std::uint32_t step_of_cell(const Workbench<D>& bench, std::uint32_t cell) {
    const auto find = [cell](const Recording& timeline) {
        const auto& steps = timeline.steps;
        const auto found =
            std::find_if(steps.begin(), steps.end(), [cell](const Step& step) { return step.item == cell_item(cell); });
        return found == steps.end() ? none : static_cast<std::uint32_t>(found - steps.begin()) + 1;
    };
    const std::uint32_t recorded = find(bench.session.timeline());
    if (recorded != none || bench.record_ahead) return recorded;
    return find(at_the_end(bench.session).timeline());
}

template <int D>
std::uint32_t whole_run(const Workbench<D>& bench) {
    return bench.record_ahead ? bench.session.recorded() : at_the_end(bench.session).recorded();
}

template void step_forward<2>(Workbench<2>&, std::uint32_t);
template void step_forward<3>(Workbench<3>&, std::uint32_t);
template void step_back<2>(Workbench<2>&, std::uint32_t);
template void step_back<3>(Workbench<3>&, std::uint32_t);
template void go_to_step<2>(Workbench<2>&, std::uint32_t);
template void go_to_step<3>(Workbench<3>&, std::uint32_t);
template void run_to_end<2>(Workbench<2>&);
template void run_to_end<3>(Workbench<3>&);
template void run_until<2>(Workbench<2>&, const Condition<2>&);
template void run_until<3>(Workbench<3>&, const Condition<3>&);
template void run_to_breakpoint<2>(Workbench<2>&, std::uint32_t);
template void run_to_breakpoint<3>(Workbench<3>&, std::uint32_t);
template std::uint32_t step_of_cell<2>(const Workbench<2>&, std::uint32_t);
template std::uint32_t step_of_cell<3>(const Workbench<3>&, std::uint32_t);
template std::uint32_t whole_run<2>(const Workbench<2>&);
template std::uint32_t whole_run<3>(const Workbench<3>&);

}  // namespace sightline
