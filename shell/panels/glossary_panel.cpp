// The words of the field, each with one sentence and its source.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/glossary.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> glossary_rows(const Workbench<D>&) {
    std::vector<Row> rows;
    for (const GlossaryEntry& entry : glossary()) {
        rows.push_back({std::string(entry.term), Tone::heading});
        rows.push_back({std::string(entry.sentence)});
        rows.back().indent = 1;
        if (entry.source != "here") rows.back().text += " (" + std::string(entry.source) + ")";
    }
    return rows;
}

template std::vector<Row> glossary_rows<2>(const Workbench<2>&);
template std::vector<Row> glossary_rows<3>(const Workbench<3>&);

}  // namespace sightline
