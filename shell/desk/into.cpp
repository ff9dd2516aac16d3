// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/into.h"

#include "core/session/substep.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"

namespace sightline {

template <int D>
void step_into(Workbench<D>& bench) {
    pause(bench);
    const auto here = bench.substep;
    if (here && *here + 1 < substep_count(bench.session, bench.session.position())) {
        bench.substep = *here + 1;
        return;
    }
    bench.substep.reset();
    step_forward(bench, 1);
    if (bench.last_stop == Stop::steps) {
        bench.substep = 0;
        return;
    }
    bench.substep = here;
    bench.say("the run ends here: " + std::string(stop_words[static_cast<std::size_t>(bench.last_stop)]));
}

template <int D>
void step_out(Workbench<D>& bench) {
    pause(bench);
    const std::uint32_t step = bench.session.position();
    if (step == 0) return;
    const std::uint32_t here = bench.substep ? *bench.substep : substep_count(bench.session, step) - 1;
    if (here > 0)
        bench.substep = here - 1;
    else
        step_back(bench, 1);
}

template void step_into<2>(Workbench<2>&);
template void step_into<3>(Workbench<3>&);
template void step_out<2>(Workbench<2>&);
template void step_out<3>(Workbench<3>&);

}  // namespace sightline
