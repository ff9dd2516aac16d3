// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/complete.h"

#include <utility>

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
void begin_completing(Workbench<D>& bench, const std::string& gesture = "") {
    const Session<D>& session = bench.session;
    const Method<D>& method = session.method();
    if (!method.orders_cells())
        throw InputError("method '" + std::string(method.id) + "' orders no cells: there is no front to complete from");
    Settings settings = session.settings();
    settings.parameters.set(cplp_first_row(), variant_of(method, settings.parameters).text);
    settings.method = "cplp";
    settings.budget = budget_up_to_here(session);
    const Completing completing{session.settings().budget, settings.budget, session.position(), none};
    change_settings(bench, settings, gesture);
    bench.completing = completing;
}

/// With the first method alone.
template <int D>
Settings settings_before(Workbench<D>& bench) {
    Settings settings = bench.session.settings();
    settings.method = settings.parameters.text(cplp_first_row());
    settings.parameters.set(cplp_first_row(), cplp_first_row().otherwise);
    if (bench.completing && bench.completing->now == settings.budget) settings.budget = bench.completing->before;
    return settings;
}

template <int D>
void end_completing(Workbench<D>& bench) {
    change_settings(bench, settings_before(bench));
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
    Flight<D>& flight = bench.flight;
    const bool in_flight = flight.on || flight.replaying || bench.session.flying();
    if (in_flight && (bench.session.method().id != "cplp" || flight.completed)) {
        flight.completes = !flight.completes;
        if (std::exchange(flight.completed, false)) end_completing(bench);
        bench.say(flight.completes ? "where the eye rests, rounds of cPLP complete the picture"
                                   : "the picture stays as the budget leaves it");
        return;
    }
    const bool back = bench.session.method().id == "cplp";
    if (back) {
        leave_rounds(bench.session);
        const auto begun = bench.completing;
        const std::uint32_t step = bench.session.position();
        end_completing(bench);
        if (begun && step == begun->rounds_from) bench.session.seek(begun->asked_at);
    } else {
        begin_completing(bench);
        leave_rounds(bench.session);  // steps without a new primitive are not in its budget
        bench.completing->rounds_from = bench.session.position();
    }
    if (!bench.session.flying()) moved(bench);
    bench.say(back ? bench.session.settings().method + " alone"
                   : "cPLP: the steps from here on are rounds, until nothing visible is missing");
}

template <int D>
bool complete_at_rest(Workbench<D>& bench) {
    Flight<D>& flight = bench.flight;
    const Session<D>& session = bench.session;
    if (!session.flying() || !flight.completes || flight.completed || session.method().id == "cplp" ||
        !session.method().orders_cells())
        return false;
    try {
        begin_completing(bench, bench.history.gesture);
    } catch (const InputError& error) {  // one whose front cPLP cannot go on from
        flight.completes = false;
        bench.say(error.what());
        return false;
    }
    flight.completed = true;
    return true;
}

template <int D>
void fly_alone(Workbench<D>& bench) {
    if (!std::exchange(bench.flight.completed, false) || bench.session.method().id != "cplp") return;
    bench.session.change(settings_before(bench));
    bench.completing.reset();
}

template void complete<2>(Workbench<2>&);
template void complete<3>(Workbench<3>&);
template bool complete_at_rest<2>(Workbench<2>&);
template bool complete_at_rest<3>(Workbench<3>&);
template void fly_alone<2>(Workbench<2>&);
template void fly_alone<3>(Workbench<3>&);

}  // namespace sightline
