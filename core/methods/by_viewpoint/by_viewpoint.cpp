// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/by_viewpoint.h"

#include "core/methods/by_viewpoint/viewpoint_run.h"

namespace sightline {

template <int D>
Method<D> viewpoint_method(std::vector<Method<D>> methods) {
    const auto shared = std::make_shared<const std::vector<Method<D>>>(std::move(methods));
    Method<D> row{by_viewpoint_id, "by viewpoint",
                  "what a table recommends for the eye's region and direction, of several techniques (DAS)",
                  [shared](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                      return std::make_unique<ViewpointRun<D>>(problem, viewpoint_table<D>(*shared, problem));
                  }};
    row.pops = Kind::node;
    row.needs.boxes = true;
    row.needs.image = true;
    row.needs.history = true;
    row.budgeted = false;
    row.draws_levels = true;  // where `levels` is a technique
    row.compared = false;     // it does what others do, and works out entries first
    row.promise = Misses::none_at_this_resolution;
    row.takes_back = [shared](const Parameters& parameters) {
        for (const std::string& text : split_variants(parameters.text(techniques_row()))) {
            const Variant<D> variant = make_variant<D>(*shared, text, parameters);
            if (variant.method.promise_with(variant.parameters) == Misses::may) return true;
        }
        return false;
    };
    row.prepare = [shared](const Problem<D>& problem) {
        const auto table = viewpoint_table<D>(*shared, problem);
        table->at(table->place(problem.view));
    };
    row.parameters = viewpoint_parameter_rows();
    return row;
}

template Method<2> viewpoint_method<2>(std::vector<Method<2>>);
template Method<3> viewpoint_method<3>(std::vector<Method<3>>);

}  // namespace sightline
