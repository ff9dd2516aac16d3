// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/time_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/measure/time_budget.h"
#include "lab/measure/wrong_budget.h"
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

TextTable budget_table(const Results& results) {
    TextTable table{{"scene", "method", "budget", "frames", "kept %", "worst ms", "total", "traversal", "upload",
                     "drawing", "drawn", "view, least ms", "view, most ms"},
                    {}};
    for (const TimedFlight& flight : results.flights) {
        const auto middle = [&](auto TimedFrame::*member) {
            std::vector<double> values;
            for (const TimedFrame& frame : flight.frames) values.push_back(static_cast<double>(frame.*member));
            return number(median(std::move(values)));
        };
        std::vector<double> all_in_view;
        for (const Row& row : results.rows)
            if (row.scene == flight.scene && row.path == flight.path && row.method.variant == view_culling)
                for (const Values& values : row.values)
                    if (!std::isnan(values[Measure::total_ms])) all_in_view.push_back(values[Measure::total_ms]);
        table.rows.push_back({flight.scene + ", " + flight.path, method_text(flight.method), flight.budget,
                              std::to_string(flight.frames.size()), per_cent(share_kept(flight)),
                              number(longest_ms(flight)), middle(&TimedFrame::total_ms),
                              middle(&TimedFrame::traverse_ms), middle(&TimedFrame::upload_ms),
                              middle(&TimedFrame::draw_ms), middle(&TimedFrame::rendered),
                              number(quantile(all_in_view, 0)), number(quantile(all_in_view, 1))});
    }
    return table;
}

TextTable wrong_budget_table(const Results& results) {
    TextTable table{{"scene", "method", "budget", "frames", "kept %", "wrong %", "worst %", "budget", "needed"}, {}};
    for (const WrongFlight& flight : results.wrong_flights) {
        double wrong = 0, worst = 0, budget = 0, needed = 0;
        const double n = static_cast<double>(flight.frames.size()) - 1;
        for (std::size_t i = 1; i < flight.frames.size(); ++i) {
            const WrongFrame& frame = flight.frames[i];
            wrong += frame.wrong / n;
            worst = std::max(worst, frame.wrong);
            budget += frame.budget / n;
            needed += frame.needed == none ? std::numeric_limits<double>::quiet_NaN() : frame.needed / n;
        }
        table.rows.push_back({flight.scene + ", " + flight.path, method_text(flight.method),
                              wrong_budget_text(flight.wrong), std::to_string(flight.frames.size()),
                              per_cent(share_kept(flight)), per_cent(wrong), per_cent(worst), number(budget),
                              number(needed)});
    }
    return table;
}

}  // namespace sightline::lab
