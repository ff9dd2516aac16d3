// Runs of methods over scenes and settings, without a session.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/methods/method_table.h"
#include "core/run/timeline.h"
#include "core/session/settings_table.h"
#include "core/truth/truth.h"

namespace sightline::test {

/// What the settings ask of a method in a view; in 2D with the exact visible set.
template <int D>
Problem<D> problem_of(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view,
                      const Settings& settings) {
    Method<D> any;
    any.needs = {.visible_set = true, .image = true};
    return make_problem(any, settings.parameters, scene, cells, view,
                        settings.budget.primitives(scene.primitives.size()), exact_services(scene, view, {}, {}));
}

/// The value of a method's parameter.
template <typename E>
E choice(const Settings& settings, const ParameterRow& row) {
    return settings.parameters.choice<E>(row);
}

/// A run recorded from its start until something stops it.
template <int D>
struct Recorded {
    OwnRun<D> run;
    Timeline<D> timeline;
};
template <int D>
Recorded<D> record_all(const Method<D>& method, const Problem<D>& problem) {
    Recorded<D> recorded;
    recorded.run = OwnRun<D>(method.start(problem));
    recorded.timeline.begin(*recorded.run);
    while (recorded.timeline.forward(recorded.run) == Stop::none) {
    }
    return recorded;
}

inline std::vector<std::uint32_t> popped_cells(const Recording& recording) {
    std::vector<std::uint32_t> cells;
    for (const Step& step : recording.steps) cells.push_back(id_of(step.item, Kind::cell));
    return cells;
}

}  // namespace sightline::test
