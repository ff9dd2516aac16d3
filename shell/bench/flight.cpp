// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/flight.h"

#include "core/error.h"
#include "shell/bench/change.h"
#include "shell/bench/moves.h"
#include "shell/bench/workbench.h"

namespace sightline {

namespace {

/// Where nobody chose a speed: this share of the scene's longest side a second.
constexpr double usual_share = 0.1;

}  // namespace

template <int D>
void fly_to(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture) {
    if (bench.session.frozen()) return change_view(bench, view, gesture);
    bench.session.check(view);
    remember(bench, gesture);
    bench.last_stop = bench.session.fly(view);
    bench.flight.traverse_ms = bench.session.times().traverse;
    if (bench.other) {
        bench.other->session.unfreeze();
        bench.other->session.fly(view);
        bench.other->lead_view = view;
    }
    ++bench.run;
    bench.substep.reset();
    bench.transport.playing = false;
    bench.marked.clear();
    bench.marked_by.clear();
    if (bench.flight.recording) bench.flight.path.frames.push_back(view);
}

template <int D>
void land(Workbench<D>& bench) {
    if (!bench.session.flying()) return;
    bench.session.land();
    if (bench.other) bench.other->session.land();
    traversal_changed(bench);
}

template <int D>
double flight_speed(const Workbench<D>& bench) {
    if (bench.flight.speed > 0) return bench.flight.speed;
    const double side = bounds<D>(bench.session.scene().primitives).longest_side();
    return side > 0 ? side * usual_share : 1;
}

template <int D>
void choose_path(Workbench<D>& bench, const std::string& id) {
    std::string known;
    for (const FlightPath<D>& path : bench.session.scene().paths) {
        if (path.id == id) {
            bench.flight.path = path;
            bench.flight.frame = 0;
            return;
        }
        known += (known.empty() ? "" : ", ") + path.id;
    }
    throw InputError("the scene has no path '" + id + "'" + (known.empty() ? "" : "; there are " + known));
}

template <int D>
void go_to_frame(Workbench<D>& bench, std::uint32_t frame) {
    const std::size_t count = bench.flight.path.frames.size();
    if (frame >= count)
        throw InputError("there is no frame " + std::to_string(frame) + ": the path has " + std::to_string(count));
    bench.flight.frame = frame;
    fly_to(bench, bench.flight.path.frames[frame], "path");
}

#define SIGHTLINE_INSTANTIATE(D)                                                    \
    template void fly_to<D>(Workbench<D>&, const ViewSpec<D>&, const std::string&); \
    template void land<D>(Workbench<D>&);                                           \
    template double flight_speed<D>(const Workbench<D>&);                           \
    template void choose_path<D>(Workbench<D>&, const std::string&);                \
    template void go_to_frame<D>(Workbench<D>&, std::uint32_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
