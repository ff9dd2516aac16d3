// The front as a sorted list, with the digits that tell its keys apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "shell/desk/into.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

using Waiting = std::pair<Item, Mark>;

/// Digits per entry that tell its key from the next lower and the next higher one; the same for equal keys.
std::vector<int> key_digits(const std::vector<Waiting>& front) {
    std::vector<int> digits(front.size(), 3);
    const auto key = [&](std::size_t i) { return front[i].second.key; };
    for (std::size_t begin = 0, end = 0; begin < front.size(); begin = end) {
        while (end < front.size() && key(end) == key(begin)) ++end;
        int most = 3;
        if (begin > 0) most = separating_digits(key(begin - 1), key(begin));
        if (end < front.size()) most = std::max(most, separating_digits(key(begin), key(end)));
        std::fill(digits.begin() + static_cast<std::ptrdiff_t>(begin),
                  digits.begin() + static_cast<std::ptrdiff_t>(end), most);
    }
    return digits;
}

}  // namespace

template <int D>
std::vector<Row> front_rows(const Workbench<D>& bench) {
    const ShownSession<D> shown(bench);
    const std::vector<Waiting> front = shown->traversal().front();
    const std::vector<int> digits = key_digits(front);
    const Kind kind = front.empty() ? Kind::cell : front.front().first.kind;
    std::vector<Row> rows{
        {std::to_string(front.size()) + " " + std::string(kind_word(kind)) + "s in the front, first to last",
         Tone::heading}};
    for (std::size_t i = 0; i < front.size(); ++i) {
        const auto& [item, mark] = front[i];
        Row row{std::to_string(i + 1) + ". " + item_name(item) + "  key " + short_number(mark.key, digits[i]) +
                "  stamp " + std::to_string(mark.stamp)};
        if (i > 0 && front[i - 1].second.key == mark.key) row.text += "  (tie, older stamp wins)";
        if (item.kind == Kind::cell) {
            row.cell = item.id;
            row.command = "select " + std::to_string(item.id);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

template std::vector<Row> front_rows<2>(const Workbench<2>&);
template std::vector<Row> front_rows<3>(const Workbench<3>&);

}  // namespace sightline
