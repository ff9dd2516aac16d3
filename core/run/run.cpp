// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/run.h"

#include "core/base/number.h"

namespace sightline {

int digits_of(const Step& step) { return step.runner_up ? separating_digits(step.key, step.runner_up_key) : 3; }

template <int D>
CodeLine budget_line(const Run<D>& run, int indent, std::string_view more, bool popping, bool in_step) {
    CodeLine line{"stop when the budget is used up" + std::string(more), indent, false, {}, "TVCG fig. 4, lines 4-5"};
    if (popping) return line;
    const std::uint32_t budget = run.problem().budget, spent = run.counters().spent;
    line.values = budget == none ? "no budget" : std::to_string(spent) + " of " + std::to_string(budget) + " spent";
    line.lit = !in_step && spent >= budget;
    return line;
}

template CodeLine budget_line<2>(const Run<2>&, int, std::string_view, bool, bool);
template CodeLine budget_line<3>(const Run<3>&, int, std::string_view, bool, bool);

}  // namespace sightline
