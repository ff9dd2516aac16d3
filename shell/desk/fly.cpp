// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/fly.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "shell/desk/change.h"
#include "shell/desk/complete.h"
#include "shell/desk/moved.h"
#include "shell/desk/undo.h"

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
    fly_alone(bench);
    fly_on(bench, view);
}

template <int D>
void land(Workbench<D>& bench) {
    if (!bench.session.flying()) return;
    bench.session.land();
    bench.flight.completed = false;
    if (bench.other) bench.other->session.land();
    traversal_changed(bench);
}

template <int D>
void land_unless_moving(Workbench<D>& bench) {
    if (!bench.flight.on && !bench.flight.replaying) land(bench);
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
        if (path.id == id) return take_path(bench, path);
        known += (known.empty() ? "" : ", ") + path.id;
    }
    throw InputError("the scene has no path '" + id + "'" + (known.empty() ? "" : "; there are " + known));
}

template <int D>
void take_path(Workbench<D>& bench, FlightPath<D> path) {
    Flight<D>& flight = bench.flight;
    if (const std::string& here = bench.session.scene().id; !path.scene.empty() && path.scene != here)
        bench.say("this path was made for " + excerpt(path.scene) + ", not for " + excerpt(here));
    set_origin(path, bench.session.scene().origin);
    flight.path = std::move(path);
    flight.recording = false;
    flight.bar = true;
    go_to_frame(bench, 0);
    land_unless_moving(bench);
}

template <int D>
void go_to_frame(Workbench<D>& bench, std::uint32_t frame) {
    const std::size_t count = bench.flight.path.frames.size();
    if (frame >= count)
        throw InputError("there is no frame " + std::to_string(frame) + ": the path has " + std::to_string(count) +
                         " frames, from 0");
    bench.flight.frame = frame;
    fly_to(bench, bench.flight.path.frames[frame], "path");
}

template <int D>
void replay(Workbench<D>& bench) {
    Flight<D>& flight = bench.flight;
    if (flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
    if (flight.frame + 1 >= flight.path.frames.size()) go_to_frame(bench, 0);
    flight.recording = false;
    flight.replaying = flight.bar = true;
    flight.owed = 0;
}

template <int D>
void record_path(Workbench<D>& bench) {
    Flight<D>& flight = bench.flight;
    const Session<D>& s = bench.session;
    if (s.frozen()) throw InputError("unfreeze the view first: a path records the culling view");
    flight.path = {"recorded", {s.culling_view()}, s.scene().id, s.scene().origin};
    flight.frame = 0;
    flight.replaying = false;
    flight.recording = flight.bar = true;
    flight.owed = 0;
}

template <int D>
void stop_path(Workbench<D>& bench) {
    bench.flight.recording = bench.flight.replaying = false;
    land_unless_moving(bench);
}

template <int D>
std::vector<Marker> frame_pops(const Workbench<D>& bench) {
    const auto& frames = bench.flight.path.frames;
    const std::uint32_t frame = bench.flight.frame;
    if (bench.session.flying() || frame == 0 || frame >= frames.size() || frames[frame] != bench.session.culling_view())
        return {};
    return pop_markers(bench.session, frames[frame - 1]);
}

template <int D>
bool advance_flight(Workbench<D>& bench, double seconds) {
    Flight<D>& flight = bench.flight;
    if (!flight.recording && !flight.replaying) return false;
    flight.owed = std::min(flight.owed + seconds * path_frames_per_second, 2.0);
    if (flight.owed < 1) return false;
    flight.owed -= 1;
    if (flight.recording) {
        const ViewSpec<D>& view = bench.session.culling_view();
        if (view != flight.path.frames.back()) flight.path.frames.push_back(view);
        flight.frame = static_cast<std::uint32_t>(flight.path.frames.size() - 1);
        return false;
    }
    const bool at_end = flight.frame + 1 >= flight.path.frames.size();
    if (at_end && !flight.loop)
        stop_path(bench);
    else
        go_to_frame(bench, at_end ? 0 : flight.frame + 1);
    return true;
}

#define SIGHTLINE_INSTANTIATE(D)                                                    \
    template void fly_to<D>(Workbench<D>&, const ViewSpec<D>&, const std::string&); \
    template void land<D>(Workbench<D>&);                                           \
    template void land_unless_moving<D>(Workbench<D>&);                             \
    template double flight_speed<D>(const Workbench<D>&);                           \
    template void choose_path<D>(Workbench<D>&, const std::string&);                \
    template void take_path<D>(Workbench<D>&, FlightPath<D>);                       \
    template void go_to_frame<D>(Workbench<D>&, std::uint32_t);                     \
    template void replay<D>(Workbench<D>&);                                         \
    template void record_path<D>(Workbench<D>&);                                    \
    template void stop_path<D>(Workbench<D>&);                                      \
    template std::vector<Marker> frame_pops<D>(const Workbench<D>&);                \
    template bool advance_flight<D>(Workbench<D>&, double);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
