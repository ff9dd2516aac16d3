// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/winners.h"

#include <array>
#include <cmath>

#include "lab/report/page.h"

namespace sightline::lab {

namespace {

constexpr std::array shares{0.05, 0.01, 0.005, 0.001, 0.0001, 0.0};

std::string row_text(const Row& row) {
    return method_text(row.method) + (row.budget == "unlimited" ? "" : " " + row.budget) + ": " +
           number(summary(row, Measure::total_ms));
}

}  // namespace

Winner winner(const Group& group, double most_wrong) {
    Winner found;
    const auto faster = [](const Row* row, const Row* than) {
        return !than || summary(*row, Measure::total_ms) < summary(*than, Measure::total_ms);
    };
    const auto counts = [&](const Row* row) {
        return row->method.variant != exactly_v && !std::isnan(summary(*row, Measure::total_ms)) &&
               summary(*row, Measure::wrong) <= most_wrong;
    };
    for (const Row* row : group.rows)
        if (counts(row) && faster(row, found.first)) found.first = row;
    for (const Row* row : group.rows)
        if (counts(row) && row->method.id() != found.first->method.id() && faster(row, found.second))
            found.second = row;
    return found;
}

TextTable winners_table(const Results& results) {
    TextTable table{{"scene, path"}, {}};
    for (const double share : shares)
        table.head.push_back(share > 0 ? "at most " + per_cent(share) + " % wrong" : "none wrong");
    for (const Group& group : groups(results)) {
        std::vector<std::string> cells{group.scene + ", " + group.path};
        bool any = false;
        for (const double share : shares) {
            const Winner at = winner(group, share);
            any |= at.first != nullptr;
            cells.push_back(!at.first ? "–" : row_text(*at.first) + (at.second ? "; " + row_text(*at.second) : ""));
        }
        if (any) table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace sightline::lab
