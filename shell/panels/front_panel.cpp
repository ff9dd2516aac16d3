// The front as a sorted list.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/number.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> front_rows(const Workbench<D>& bench) {
    const Session<D>& s = bench.session;
    std::vector<Front::Entry> entries;
    for (std::uint32_t cell = 0; cell < s.cells().cell_count(); ++cell)
        if (const CellMark mark = s.state().mark(cell); mark.state == CellState::enqueued)
            entries.push_back({mark.key, mark.stamp, cell});
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.before(b); });
    std::vector<Row> rows{{std::to_string(entries.size()) + " cells in the front", Tone::heading}};
    for (const Front::Entry& entry : entries) {
        Row row{"cell " + std::to_string(entry.cell) + "  key " + short_number(entry.key) + "  stamp " +
                std::to_string(entry.stamp)};
        row.cell = entry.cell;
        row.command = "select " + std::to_string(entry.cell);
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> front_rows<2>(const Workbench<2>&);

}  // namespace sightline
