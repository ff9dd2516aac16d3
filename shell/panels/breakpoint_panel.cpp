// Breakpoints, and the steps that `mark` found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> breakpoint_rows(const Workbench<D>& bench) {
    std::vector<Row> rows{{"Breakpoints", Tone::heading}};
    const auto& breakpoints = bench.session.breakpoints;
    for (std::size_t i = 0; i < breakpoints.size(); ++i) {
        Row row{(breakpoints[i].on ? "[x] " : "[ ] ") + breakpoints[i].condition};
        row.command = "break-switch " + std::to_string(i + 1);
        rows.push_back(std::move(row));
    }
    if (breakpoints.empty())
        rows.push_back({"none; press F9, then type step:N, cell:ID, object:NAME or an expression", Tone::faint});
    rows.push_back({"Marked steps", Tone::heading});
    if (bench.marked_by.empty())
        rows.push_back({"none; type mark CONDITION", Tone::faint});
    else
        rows.push_back({std::to_string(bench.marked.size()) + " match " + bench.marked_by});
    for (const std::uint32_t step : bench.marked) {
        Row row{"step " + std::to_string(step)};
        row.indent = 1;
        row.command = "seek " + std::to_string(step);
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> breakpoint_rows<2>(const Workbench<2>&);
template std::vector<Row> breakpoint_rows<3>(const Workbench<3>&);

}  // namespace sightline
