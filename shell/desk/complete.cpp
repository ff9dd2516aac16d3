// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/complete.h"

#include "core/base/error.h"
#include "core/methods/cplp/cplp.h"
#include "shell/desk/change.h"
#include "shell/desk/moved.h"

namespace sightline {

namespace {

/// A flight shows ends of runs, so that it keeps the budget; so does a run that has reached it, but for one in time,
/// which another run would reach elsewhere.
template <int D>
Budget budget_up_to_here(const Session<D>& session) {
    const Budget& budget = session.settings().budget;
    const bool at_its_end = session.flying() || session.finished();
    if (at_its_end && budget.kind != Budget::Kind::milliseconds) return budget;
    return {Budget::Kind::primitives, static_cast<double>(session.counters().spent)};
}

template <int D>
void begin_completing(Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    const Method<D>& method = session.method();
    if (!method.orders_cells())
        throw InputError("method '" + std::string(method.id) + "' orders no cells: there is no front to complete from");
    Settings settings = session.settings();
    settings.parameters.set(cplp_first_row(), variant_of(method, settings.parameters).text);
    settings.method = "cplp";
    settings.budget = budget_up_to_here(session);
    const Completing completing{session.settings().budget, settings.budget};
    change_settings(bench, settings);
    bench.completing = completing;
}

template <int D>
void end_completing(Workbench<D>& bench) {
    Settings settings = bench.session.settings();
    settings.method = settings.parameters.text(cplp_first_row());
    settings.parameters.set(cplp_first_row(), cplp_first_row().otherwise);
    if (bench.completing && bench.completing->now == settings.budget) settings.budget = bench.completing->before;
    change_settings(bench, settings);
    bench.completing.reset();
}

/// Back to where the first method ended.
template <int D>
void leave_rounds(Session<D>& session) {
    const auto in_a_round = [&] {
        const std::uint32_t position = session.position();
        return position > 0 && session.timeline().steps[position - 1].item.kind == Kind::round;
    };
    while (in_a_round()) session.back();
}

}  // namespace

template <int D>
void complete(Workbench<D>& bench) {
    const bool back = bench.session.method().id == "cplp";
    if (back) {
        leave_rounds(bench.session);
        end_completing(bench);
    } else {
        begin_completing(bench);
        leave_rounds(bench.session);  // steps without a new primitive are not in its budget
    }
    if (!bench.session.flying()) moved(bench);
    bench.say(back ? bench.session.settings().method + " alone"
                   : "cPLP: the steps from here on are rounds, until nothing visible is missing");
}

template void complete<2>(Workbench<2>&);
template void complete<3>(Workbench<3>&);

}  // namespace sightline
