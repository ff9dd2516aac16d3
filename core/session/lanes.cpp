// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/lanes.h"

#include <algorithm>
#include <limits>

namespace sightline {

template <int D>
Lanes make_lanes(const Session<D>& session) {
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
    // What undone steps met is known at the end of the recording.
    const Session<D> end = copy_at(session, session.recorded());

    const Reference& reference = session.reference();
    const Timeline<D>& timeline = end.timeline();
    const std::size_t steps = timeline.steps.size();
    Lanes lanes;
    lanes.cell.reserve(steps);
    for (auto* lane : {&lanes.visible, &lanes.hidden, &lanes.rendered, &lanes.front}) lane->reserve(steps);
    for (auto* lane : {&lanes.key, &lanes.coverage, &lanes.oracle}) lane->reserve(steps);
    std::size_t visible_so_far = 0;
    for (std::uint32_t step = 1; step <= steps; ++step) {
        const Counters &before = timeline.before(step), &after = timeline.after(step);
        const std::size_t visible = visible_rendered(reference, timeline.met_in(step, end.met()));
        visible_so_far += visible;
        if (after.stood_in > before.stood_in)
            for (const std::uint32_t p : end.traversal().levels()->primitives_of(timeline.steps[step - 1].item.id))
                visible_so_far += reference.visible[p];
        const Step& popped = timeline.steps[step - 1];
        lanes.cell.push_back(id_of(popped.item, Kind::cell));
        lanes.visible.push_back(static_cast<std::uint32_t>(visible));
        lanes.hidden.push_back(after.rendered_count - before.rendered_count - lanes.visible.back());
        lanes.rendered.push_back(after.drawn());
        lanes.front.push_back(after.front_size);
        lanes.key.push_back(popped.item ? popped.key : no_value);
        lanes.coverage.push_back(coverage(reference, visible_so_far).value_or(no_value));
        lanes.oracle.push_back(oracle(reference, after.drawn()).value_or(no_value));
    }
    return lanes;
}

template <int D>
std::uint32_t step_of_rendered(const Session<D>& session, std::uint32_t rendered) {
    if (rendered == 0) return 0;
    const std::vector<Step>& steps = session.timeline().steps;
    const auto found = std::partition_point(steps.begin(), steps.end(),
                                            [&](const Step& step) { return step.after.drawn() < rendered; });
    return found == steps.end() ? session.recorded() : static_cast<std::uint32_t>(found - steps.begin()) + 1;
}

template Lanes make_lanes<2>(const Session<2>&);
template Lanes make_lanes<3>(const Session<3>&);
template std::uint32_t step_of_rendered<2>(const Session<2>&, std::uint32_t);
template std::uint32_t step_of_rendered<3>(const Session<3>&, std::uint32_t);

}  // namespace sightline
