// Inversions, most wasted primitives first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/headline.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> inversion_rows(const Workbench<D>& bench) {
    if (bench.session.flying())
        return {{"Flying", Tone::heading}, {"frames of a flight are not recorded: their order is not known"}};
    if (!tells_truth(bench.session)) return {{"What is visible is hidden: Shift+H tells it", Tone::faint}};
    const auto found = bench.session.inversions();
    std::vector<Row> rows{{"Inversions in the recorded run: " + std::to_string(found.size()), Tone::heading}};
    for (const Inversion& i : found) {
        Row row{"step " + std::to_string(i.step) + ": hidden cell " + std::to_string(i.cell) + " before cell " +
                std::to_string(i.waiting) + ", " + std::to_string(i.wasted) + " wasted, " +
                (i.kind == Inversion::Kind::mis_ranked ? "mis-ranked" : "unreached")};
        row.cell = i.cell;
        row.command = "seek " + std::to_string(i.step) + "; select " + std::to_string(i.waiting);
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> inversion_rows<2>(const Workbench<2>&);
template std::vector<Row> inversion_rows<3>(const Workbench<3>&);

}  // namespace sightline
