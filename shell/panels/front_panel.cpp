// The front as a sorted list, with the digits that tell its keys apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "shell/desk/into.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

/// Digits per entry that tell its key from the next lower and the next higher one; the same for equal keys.
std::vector<int> key_digits(const std::vector<Front::Entry>& entries) {
    std::vector<int> digits(entries.size(), 3);
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
        while (end < entries.size() && entries[end].key == entries[begin].key) ++end;
        int most = 3;
        if (begin > 0) most = separating_digits(entries[begin - 1].key, entries[begin].key);
        if (end < entries.size()) most = std::max(most, separating_digits(entries[begin].key, entries[end].key));
        std::fill(digits.begin() + static_cast<std::ptrdiff_t>(begin),
                  digits.begin() + static_cast<std::ptrdiff_t>(end), most);
    }
    return digits;
}

}  // namespace

template <int D>
std::vector<Row> front_rows(const Workbench<D>& bench) {
    const Shown<D> shown(bench);
    const std::vector<Front::Entry> entries = front_entries(*shown);
    const std::vector<int> digits = key_digits(entries);
    std::vector<Row> rows{{std::to_string(entries.size()) + " cells in the front, first to last", Tone::heading}};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Front::Entry& entry = entries[i];
        Row row{std::to_string(i + 1) + ". cell " + std::to_string(entry.cell) + "  key " +
                short_number(entry.key, digits[i]) + "  stamp " + std::to_string(entry.stamp)};
        if (i > 0 && entries[i - 1].key == entry.key) row.text += "  (tie, older stamp wins)";
        row.cell = entry.cell;
        row.command = "select " + std::to_string(entry.cell);
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> front_rows<2>(const Workbench<2>&);
template std::vector<Row> front_rows<3>(const Workbench<3>&);

}  // namespace sightline
