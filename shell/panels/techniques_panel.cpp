// Which techniques suit the scene, and which of them are here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/techniques.h"

#include "core/base/text.h"
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> technique_rows(const Workbench<D>& bench) {
    std::vector<Row> rows;
    for (const Suits wanted : {Suits::yes, Suits::in_part, Suits::no}) {
        const std::size_t heading = rows.size();
        std::size_t count = 0, here = 0;
        rows.push_back({"", Tone::heading});
        for (const Technique& technique : techniques()) {
            const Suitability found = suitability(technique, bench.session.scene());
            if (found.suits != wanted) continue;
            ++count;
            here += technique.is_here();
            Row row{std::string(technique.name) + (technique.is_here() ? ": " + std::string(technique.method) : ""),
                    technique.is_here() ? Tone::link : Tone::faint};
            row.indent = 1;
            row.command = "techniques " + std::string(technique.id);
            row.tip = needs_words(technique) + "; " + finds_words(technique);
            rows.push_back(std::move(row));
            rows.push_back({found.reason + (technique.is_here() ? "" : "; not here: " + std::string(technique.absent)),
                            Tone::faint});
            rows.back().indent = 2;
        }
        const std::string_view words_of = word(wanted);
        rows[heading].text = static_cast<char>(words_of[0] - 'a' + 'A') + std::string(words_of.substr(1)) + ": " +
                             counted(count, "technique") + ", " + std::to_string(here) + " of them here";
    }
    return rows;
}

template std::vector<Row> technique_rows<2>(const Workbench<2>&);
template std::vector<Row> technique_rows<3>(const Workbench<3>&);

}  // namespace sightline
