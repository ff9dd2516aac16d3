// Which charts a study gets: the trade-off of speed and accuracy, and curves over the frames of a path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/measure/results.h"
#include "lab/report/chart.h"

namespace sightline::lab {

struct NamedChart {
    std::string scene, path;
    std::string id;    ///< of the file, e.g. "city-test-trade-off-wrong"
    std::string text;  ///< one sentence: how to read it
    Chart chart;
};

/// The rows of one scene and path.
struct Group {
    std::string scene, path;
    std::vector<const Row*> rows;
};
std::vector<Group> groups(const Results& results);

/// A dot that no other one beats in both its cost and the measure.
struct TradeOffPoint {
    const Row* row;
    double cost, value;
};
/// By cost: total_ms, rendered or tested. Rows without a cost or a value are left out; equal ones are all there.
std::vector<TradeOffPoint> pareto_points(const std::vector<const Row*>& rows, Measure measure,
                                         Measure cost = Measure::total_ms);

/// x what a frame costs, y wrong pixels or coverage: a line per method, a dot per budget, the line of the Pareto points
/// under them and, over coverage and time, the oracle, which draws as fast as the fastest and needs no traversal.
Chart trade_off(const Group& group, Measure measure, Measure cost = Measure::total_ms);

/// Every chart of a study, group by group (TVCG figs. 10 to 12 and 15 in form).
std::vector<NamedChart> study_charts(const Results& results);

}  // namespace sightline::lab
