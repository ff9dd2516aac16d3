// The row of a heuristic that orders cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_run.h"
#include "core/run/method.h"

namespace sightline {

/// The parameters that all of them have, and `own`.
inline std::vector<const ParameterRow*> cell_parameter_rows(std::vector<const ParameterRow*> own = {}) {
    for (const auto* row :
         {&outside_view_row(), &culled_cost_row(), &budget_counts_row(), &neighbours_before_break_row(), &seeds_row()})
        own.push_back(row);
    return own;
}

/// A heuristic is described in cell_run.h.
template <int D, typename Heuristic>
Method<D> cell_method(std::string_view id, std::string_view title, std::string_view sentence,
                      std::vector<const ParameterRow*> own_parameters = {}) {
    Method<D> method{id, title, sentence, [](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                         return std::make_unique<CellRun<D, Heuristic>>(problem);
                     }};
    method.parameters = cell_parameter_rows(std::move(own_parameters));
    return method;
}

}  // namespace sightline
