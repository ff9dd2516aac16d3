// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_data.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/session/lanes.h"
#include "shell/desk/compare.h"
#include "shell/desk/fly.h"

namespace sightline {

namespace {

template <int D>
void read_run(TimelineData& data, const Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    Lanes lanes = make_lanes(session);
    const std::size_t steps = lanes.cell.size();
    const auto set = [&](Curve curve, const auto& lane) {
        const auto i = static_cast<std::size_t>(curve);
        data.values[i].assign(lane.begin(), lane.end());
        data.lowest[i] = data.highest[i] = 0;
        for (const double value : data.values[i]) {
            if (!std::isfinite(value)) continue;
            data.lowest[i] = std::min(data.lowest[i], value);
            data.highest[i] = std::max(data.highest[i], value);
        }
    };
    set(Curve::visible, lanes.visible);
    set(Curve::hidden, lanes.hidden);
    set(Curve::key, lanes.key);
    set(Curve::front, lanes.front);
    set(Curve::coverage, lanes.coverage);
    set(Curve::oracle, lanes.oracle);
    data.other_coverage.clear();
    if (bench.other) data.other_coverage = make_lanes(bench.other->session).coverage;
    data.step_of_cell.assign(session.cells().cell_count(), 0);
    for (std::size_t i = 0; i < steps; ++i)
        if (lanes.cell[i] != none) data.step_of_cell[lanes.cell[i]] = static_cast<std::uint32_t>(i) + 1;
    data.cell = std::move(lanes.cell);
    data.by_steps.resize(steps + 1);
    std::iota(data.by_steps.begin(), data.by_steps.end(), 0u);
    data.by_primitives.assign(1, 0);
    data.by_primitives.insert(data.by_primitives.end(), lanes.rendered.begin(), lanes.rendered.end());
    data.found = session.markers();
    const std::vector<Marker> pops = frame_pops(bench);
    data.found.insert(data.found.end(), pops.begin(), pops.end());
    data.budgets.clear();
    for (const Marker& marker : data.found)
        if (marker.kind == Marker::Kind::budget) data.budgets.push_back({marker.step, marker.label});
    data.run = bench.run;
    data.marks = timeline_marks(bench, data.found);
    data.axis = {};
}

/// Where marks of people changed.
template <int D>
void update_marks(TimelineData& data, const Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    const std::uint32_t difference = bench.other ? first_difference(bench).step : none;
    if (data.bookmarks == session.bookmarks && data.breakpoints == session.breakpoints &&
        data.matched == bench.marked && data.difference == difference)
        return;
    data.difference = difference;
    data.bookmarks = session.bookmarks;
    data.breakpoints = session.breakpoints;
    data.matched = bench.marked;
    data.marks = timeline_marks(bench, data.found);
    data.axis = {};
}

}  // namespace

template <int D>
bool update_run(TimelineData& data, const Workbench<D>& bench) {
    // Frames of a flight are not recorded: what was there stays.
    if (!bench.session.flying() && data.run != bench.run) read_run(data, bench);
    return !data.cell.empty();
}

template <int D>
bool update(TimelineData& data, const Workbench<D>& bench, float x, float w, float unit) {
    const bool any = update_run(data, bench);
    if (!bench.session.flying()) update_marks(data, bench);
    if (!any) return false;
    data.counts = bench.desk.axis;
    const auto& ends = data.counts == TimelineAxis::steps ? data.by_steps : data.by_primitives;
    const StepAxis axis = make_axis(ends, {bench.desk.timeline_from, bench.desk.timeline_to}, x, w);
    const StepAxis& old = data.axis;
    if (old.ends.data() == axis.ends.data() && old.from == axis.from && old.to == axis.to && old.x == axis.x &&
        old.w == axis.w && data.unit == unit)
        return true;
    data.axis = axis;
    data.unit = unit;
    for (std::size_t i = 0; i < data.spans.size(); ++i) data.spans[i] = lane_spans(axis, data.values[i], most_columns);
    data.groups = mark_groups(axis, data.marks, 8 * unit, 2 * unit);
    return true;
}

template bool update_run<2>(TimelineData&, const Workbench<2>&);
template bool update_run<3>(TimelineData&, const Workbench<3>&);
template bool update<2>(TimelineData&, const Workbench<2>&, float, float, float);
template bool update<3>(TimelineData&, const Workbench<3>&, float, float, float);

}  // namespace sightline
