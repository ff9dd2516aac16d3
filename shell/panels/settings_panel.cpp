// Every setting as a line: name, value, and where the question comes from.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/panel_table.h"

namespace sightline {

template <int D>
std::vector<Row> settings_rows(const Workbench<D>& bench) {
    const Settings defaults;
    std::vector<Row> rows;
    for (const SettingRow& setting : settings_table()) {
        if (!applies<D>(setting, bench.session.method())) continue;
        const std::string value = setting.get(bench.session.settings());
        Row row{std::string(setting.name) + " = " + value};
        if (value != setting.get(defaults)) row.tone = Tone::lit;
        row.tip =
            std::string(setting.help) + " (" + std::string(setting.values) + "; " + std::string(setting.source) + ")";
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> settings_rows<2>(const Workbench<2>&);
template std::vector<Row> settings_rows<3>(const Workbench<3>&);

}  // namespace sightline
