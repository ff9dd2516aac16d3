// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/play.h"

#include <algorithm>
#include <cmath>

#include "shell/desk/moves.h"

namespace sightline {

namespace {

/// No frame makes up for more than this: after a long pause of the machine the run goes on, it does not jump.
constexpr double longest_tick_seconds = 0.25;

}  // namespace

template <int D>
TransportState transport_state(const Workbench<D>& bench) {
    if (bench.transport.playing) return TransportState::playing;
    if (bench.session.finished()) return TransportState::finished;
    return bench.session.position() == 0 ? TransportState::ready : TransportState::paused;
}

template <int D>
void play(Workbench<D>& bench) {
    if (bench.session.finished()) go_to_step(bench, 0);
    bench.transport.playing = true;
    bench.transport.owed = 0;
}

template <int D>
void pause(Workbench<D>& bench) {
    bench.transport.playing = false;
}

template <int D>
void play_whole_run_in(Workbench<D>& bench, double seconds) {
    bench.transport.steps_per_second = std::clamp(whole_run(bench) / seconds, slowest, fastest);
    play(bench);
}

template <int D>
void advance_clock(Workbench<D>& bench, double seconds) {
    Transport& transport = bench.transport;
    if (!transport.playing) return;
    transport.owed += std::min(seconds, longest_tick_seconds) * transport.steps_per_second;
    const double due = std::floor(transport.owed);
    transport.owed -= due;
    if (due < 1) return;
    run_to_breakpoint(bench, static_cast<std::uint32_t>(due));
    if (bench.last_stop != Stop::steps || bench.session.finished()) transport.playing = false;
}

template TransportState transport_state<2>(const Workbench<2>&);
template TransportState transport_state<3>(const Workbench<3>&);
template void play<2>(Workbench<2>&);
template void play<3>(Workbench<3>&);
template void pause<2>(Workbench<2>&);
template void pause<3>(Workbench<3>&);
template void play_whole_run_in<2>(Workbench<2>&, double);
template void play_whole_run_in<3>(Workbench<3>&, double);
template void advance_clock<2>(Workbench<2>&, double);
template void advance_clock<3>(Workbench<3>&, double);

}  // namespace sightline
