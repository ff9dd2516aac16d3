// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/time_table.h"

#include "lab/report/page.h"

namespace sightline::lab {

TextTable time_table(const Group& group) {
    using M = Measure;
    TextTable table{{"method", "budget", "drawn", "drawn / V", "tested", "rounds", "traversal", "upload", "drawing",
                     "total", "total / V's", "Hz", "lower quartile", "median", "upper quartile"},
                    {}};
    for (const Row* row : group.rows) {
        std::vector<std::string>& cells = table.rows.emplace_back();
        cells = {method_text(row->method), row->budget};
        for (const M m : {M::rendered, M::emitted_over_visible, M::tested, M::rounds, M::traverse_ms, M::upload_ms,
                          M::draw_ms, M::total_ms, M::over_exact})
            cells.push_back(number(summary(*row, m)));
        const Spread rate = hz(*row);
        for (const double value : {rate.mean, rate.lower_quartile, rate.median, rate.upper_quartile})
            cells.push_back(number(value));
    }
    return table;
}

}  // namespace sightline::lab
