// Why this cell now, and where the selected cell stands.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"
#include "shell/bench/into.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

void add(std::vector<Row>& to, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        Row row;
        const std::size_t spaces = line.find_first_not_of(' ');
        row.text = line.substr(spaces == std::string::npos ? 0 : spaces);
        row.indent = static_cast<int>(spaces / 2);
        to.push_back(std::move(row));
    }
}

}  // namespace

template <int D>
std::vector<Row> why_rows(const Workbench<D>& bench) {
    const Shown<D> shown(bench);
    const Session<D>& s = *shown;
    std::vector<Row> rows;
    rows.push_back({bench.substep ? "This step, as far as it is done" : "This step", Tone::heading});
    if (s.position() == 0)
        rows.push_back({"Step 0: the seed cell is in the front, nothing is projected yet."});
    else
        add(rows, sightline::rows(explain_step(s, s.position()), s.settings()));
    rows.push_back({"Selected cell", Tone::heading});
    if (s.selected_cell == none)
        rows.push_back({"Click a cell in the picture.", Tone::faint});
    else
        add(rows, sightline::rows(explain_cell(s, s.selected_cell), s.settings()));
    return rows;
}

template std::vector<Row> why_rows<2>(const Workbench<2>&);

}  // namespace sightline
