// The algorithm as numbered lines, with the one where the session stands and the values of this step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pseudocode.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> code_rows(const Workbench<D>& bench) {
    std::vector<Row> rows;
    int number = 0;
    for (const CodeLine& line : pseudocode(bench.session, bench.substep)) {
        Row row{std::to_string(++number) + ". " + line.text};
        row.indent = line.indent;
        row.tip = line.source;
        if (line.lit) row.tone = Tone::lit;
        rows.push_back(row);
        if (line.values.empty()) continue;
        row.text = line.values;
        row.indent += 2;
        if (!line.lit) row.tone = Tone::faint;
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> code_rows<2>(const Workbench<2>&);
template std::vector<Row> code_rows<3>(const Workbench<3>&);

}  // namespace sightline
