// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/study_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/number.h"
#include "core/draw/palette.h"
#include "core/measure/distance.h"
#include "core/measure/summary.h"
#include "lab/measure/wrong_budget.h"
#include "lab/report/method_looks.h"

namespace sightline::lab {

namespace {

bool in_per_cent(Measure measure) { return measure_row(measure).unit == "share"; }
double scaled(Measure measure, double value) { return in_per_cent(measure) ? 100 * value : value; }
std::string axis(Measure measure) {
    const MeasureRow& row = measure_row(measure);
    return std::string(row.title) + ", " + (in_per_cent(measure) ? "%" : std::string(row.unit));
}

/// Rows of a group by method, methods in the study's order.
std::vector<std::vector<const Row*>> by_method(const Group& group) {
    std::vector<std::vector<const Row*>> methods;
    for (const Row* row : group.rows) {
        const auto same = [&](const auto& rows) { return rows.front()->method == row->method; };
        const auto at = std::find_if(methods.begin(), methods.end(), same);
        at == methods.end() ? methods.push_back({row}) : at->push_back(row);
    }
    return methods;
}

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr Colour black{0, 0, 0}, dark_grey{68, 68, 68}, light_grey{200, 200, 200};

/// A line to compare methods with.
Series guide(const std::string& name, const Colour& colour, std::span<const float> dash = {}) {
    return {name, {colour, dash}, Series::Shown::line, 2, {}, {}};
}

std::string heading(const Group& group) { return group.scene + ", path " + group.path; }

const Row* largest_budget(const std::vector<const Row*>& rows) {
    return *std::max_element(rows.begin(), rows.end(), [](const Row* a, const Row* b) {
        return summary(*a, Measure::budget) < summary(*b, Measure::budget);
    });
}

/// Whether frames of the path were left out between these.
bool are_sampled(const std::vector<std::uint32_t>& frames) {
    return frames.size() > 1 && frames.back() - frames.front() + 1 > frames.size();
}

/// How well the repeats tell the time per frame: the standard error of its mean over frames.
double time_error(const Row& row) {
    double squares = 0;
    for (const Values& v : row.values) squares += v[Measure::total_error] * v[Measure::total_error];
    return std::sqrt(squares) / static_cast<double>(row.values.size());
}

/// One curve per method at its largest budget.
Chart per_frame(const Group& group, Measure measure) {
    Chart chart;
    chart.title = heading(group) + ": " + std::string(measure_row(measure).title);
    chart.x = "frame of the path";
    chart.y = axis(measure);
    chart.is_share = in_per_cent(measure);
    const MethodLooks looks = MethodLooks::of(group.rows);
    const auto error = error_of(measure);
    for (const auto& rows : by_method(group)) {
        const Row* row = largest_budget(rows);
        Series s = looks.series(row->method);
        if (row->budget != "unlimited") s.name += " " + row->budget;
        s.sampled = are_sampled(row->frames);
        for (std::size_t i = 0; i < row->frames.size(); ++i) {
            s.points.push_back({static_cast<double>(row->frames[i]), scaled(measure, row->values[i][measure])});
            if (error) s.errors.push_back({nothing, row->values[i][*error]});
        }
        chart.series.push_back(std::move(s));
    }
    return chart;
}

/// The share of the pixels at a distance that are wrong there: one curve per method at its largest budget.
Chart wrong_by_distance(const Group& group) {
    Chart chart;
    chart.title = heading(group) + ": wrong pixels by distance from the eye";
    chart.x = "distance, up to this share of the scene's longest side (the last dot: beyond it)";
    chart.y = "wrong pixels, % of the pixels at that distance";
    chart.log_x = true;
    chart.is_share = true;
    const MethodLooks looks = MethodLooks::of(group.rows);
    for (const auto& rows : by_method(group)) {
        const Row* row = largest_budget(rows);
        Series s = looks.series(row->method);
        if (row->budget != "unlimited") s.name += " " + row->budget;
        const DistanceBins wrong = mean_of(*row, &Values::wrong_at), pixels = mean_of(*row, &Values::pixels_at);
        for (std::size_t bin = 0; bin < distance_bins; ++bin) {
            const bool last = bin + 1 == distance_bins;
            const double end = last ? 2 * distance_bin_end(bin - 1) : distance_bin_end(bin);
            s.points.push_back({end, pixels[bin] > 0 ? 100 * wrong[bin] / pixels[bin] : nothing});
        }
        chart.series.push_back(std::move(s));
    }
    return chart;
}

/// How many visible primitives each budget of one method finds, under the exact count (TVCG figs. 10 and 11).
Chart found_per_frame(const Group& group, const std::vector<const Row*>& rows) {
    Chart chart;
    chart.title = heading(group) + ": visible primitives found by " + method_text(rows.front()->method);
    chart.x = "frame of the path";
    chart.y = "primitives";
    Series exact = guide("exact", black);
    exact.width = 3;
    const Row& first = *rows.front();
    exact.sampled = are_sampled(first.frames);
    if (exact.sampled) exact.shown = Series::Shown::line_and_markers;
    for (std::size_t i = 0; i < first.frames.size(); ++i)
        exact.points.push_back({static_cast<double>(first.frames[i]), first.values[i][Measure::visible]});
    chart.series.push_back(std::move(exact));
    const auto add = [&](const Row& row, Series s) {
        s.sampled = are_sampled(row.frames);
        for (std::size_t i = 0; i < row.frames.size(); ++i)
            s.points.push_back({static_cast<double>(row.frames[i]),
                                row.values[i][Measure::coverage] * row.values[i][Measure::visible]});
        chart.series.push_back(std::move(s));
    };
    const MethodLooks looks = MethodLooks::of(group.rows);
    // The method's own line, paler for smaller budgets.
    const std::vector<Colour> pale{{225, 225, 225}, looks.look(rows.front()->method).colour};
    for (std::size_t i = rows.size(); i-- > 0;) {
        Series s = looks.series(rows[i]->method);
        s.name = rows[i]->budget;
        s.look.colour = between(pale, static_cast<double>(i + 1) / static_cast<double>(rows.size()));
        s.look.marker = static_cast<ChartMarker>(i % marker_count);
        add(*rows[i], std::move(s));
    }
    for (const auto& other : by_method(group))
        if (other.front()->method.variant == "centroid") {
            Series s = looks.series(other.front()->method);
            s.name = "centroid " + largest_budget(other)->budget;
            add(*largest_budget(other), std::move(s));
        }
    return chart;
}

/// What budgets in time came to, frame by frame, in primitives: the median over the repeats of each frame.
Chart budget_per_frame(const Group& group, const std::vector<const TimedFlight*>& flights) {
    Chart chart;
    chart.title = heading(group) + ": what a budget in time pays for";
    chart.x = "frame of the path";
    chart.y = "rendered primitives";
    const std::vector<std::uint32_t>& frames = group.rows.front()->frames;
    const MethodLooks looks = MethodLooks::of(group.rows);
    for (const TimedFlight* const flight : flights) {
        Series s = looks.series(flight->method);
        s.name += " " + flight->budget;
        s.look.marker = static_cast<ChartMarker>(chart.series.size() % marker_count);  // budgets of one method
        s.sampled = are_sampled(frames);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            std::vector<double> rendered;
            for (std::size_t at = i; at < flight->frames.size(); at += frames.size())
                rendered.push_back(flight->frames[at].rendered);
            s.points.push_back({static_cast<double>(frames[i]), median(std::move(rendered))});
        }
        chart.series.push_back(std::move(s));
    }
    return chart;
}

/// What budgets in wrong pixels came to, and dashed what would have done.
Chart wrong_budget_per_frame(const Group& group, const std::vector<const WrongFlight*>& flights) {
    Chart chart;
    chart.title = heading(group) + ": budgets that follow wrong pixels";
    chart.x = "frame of the path";
    chart.y = "budget, primitives";
    chart.log_y = true;
    const std::vector<std::uint32_t>& frames = group.rows.front()->frames;
    const MethodLooks looks = MethodLooks::of(group.rows);
    for (const WrongFlight* const flight : flights) {
        Series s = looks.series(flight->method);
        s.name += " " + wrong_budget_text(flight->wrong);
        s.sampled = are_sampled(frames);
        s.look.marker = static_cast<ChartMarker>(chart.series.size() / 2 % marker_count);
        Series needed = guide(s.name + ", needed", s.look.colour, guide_dash);
        for (std::size_t i = 0; i < std::min(frames.size(), flight->frames.size()); ++i) {
            const WrongFrame& frame = flight->frames[i];
            const auto at = static_cast<double>(frames[i]);
            s.points.push_back({at, std::max(1.0, static_cast<double>(frame.budget))});
            needed.points.push_back(
                {at, frame.needed == none ? nothing : std::max(1.0, static_cast<double>(frame.needed))});
        }
        chart.series.push_back(std::move(s));
        chart.series.push_back(std::move(needed));
    }
    return chart;
}

}  // namespace

std::vector<Group> groups(const Results& results) {
    std::vector<Group> all;
    for (const Row& row : results.rows) {
        if (all.empty() || all.back().scene != row.scene || all.back().path != row.path)
            all.push_back({row.scene, row.path, {}});
        all.back().rows.push_back(&row);
    }
    return all;
}

std::vector<TradeOffPoint> pareto_points(const std::vector<const Row*>& rows, Measure measure, Measure cost) {
    std::vector<Trade> trades;
    for (const Row* row : rows) trades.push_back({summary(*row, cost), summary(*row, measure)});
    std::vector<TradeOffPoint> front;
    for (const std::size_t i : sightline::pareto_points(trades, measure_row(measure).better))
        front.push_back({rows[i], trades[i].ms, trades[i].value});
    return front;
}

Chart trade_off(const Group& group, Measure measure, Measure cost) {
    const bool by_time = cost == Measure::total_ms;
    Chart chart;
    chart.title = heading(group) + (by_time                     ? ": speed and accuracy"
                                    : cost == Measure::rendered ? ": what is drawn, and accuracy"
                                                                : ": what is tested, and accuracy");
    const bool drawn = std::any_of(group.rows.begin(), group.rows.end(),
                                   [](const Row* row) { return !std::isnan(summary(*row, Measure::draw_ms)); });
    chart.x = by_time ? std::string("time per frame, ms (") +
                            (drawn ? "traversal + upload + drawing" : "traversal alone") + "; median over frames)"
                      : axis(cost) + " (mean over frames)";
    chart.y = axis(measure) + " (mean over frames)";
    chart.log_x = true;
    chart.is_share = in_per_cent(measure);

    Series front = guide("Pareto points", light_grey);
    front.width = 7;
    std::vector<const Row*> real = group.rows;
    std::erase_if(real, [](const Row* row) { return row->method.variant == exactly_v; });  // nobody is told V
    for (const TradeOffPoint& point : pareto_points(real, measure, cost))
        front.points.push_back({point.cost, scaled(measure, point.value)});
    chart.series.push_back(std::move(front));

    const MethodLooks looks = MethodLooks::of(group.rows);
    Series oracle = guide("oracle (drawing alone)", dark_grey, guide_dash);
    std::map<double, std::array<double, 2>> best;  ///< by budget
    for (const auto& rows : by_method(group)) {
        Series s = looks.series(rows.front()->method);
        for (const Row* row : rows) {
            s.points.push_back({summary(*row, cost), scaled(measure, summary(*row, measure))});
            s.labels.push_back(row->budget == "unlimited" ? "" : row->budget);
            if (by_time) s.errors.push_back({time_error(*row), nothing});
            if (row->budget == "unlimited") continue;
            double drawing = summary(*row, Measure::upload_ms) + summary(*row, Measure::draw_ms);
            if (std::isnan(drawing)) continue;
            auto& point = best.try_emplace(summary(*row, Measure::budget), std::array{drawing, 0.0}).first->second;
            point = {std::min(point[0], drawing), scaled(measure, summary(*row, Measure::oracle))};
        }
        chart.series.push_back(std::move(s));
    }
    if (measure == Measure::coverage && by_time) {
        for (const auto& [budget, point] : best) oracle.points.push_back(point);
        std::sort(oracle.points.begin(), oracle.points.end());
        chart.series.push_back(std::move(oracle));
    }
    return chart;
}

std::vector<NamedChart> study_charts(const Results& results) {
    std::vector<NamedChart> charts;
    for (const Group& group : groups(results)) {
        const std::string stem = file_stem(group.scene + "-" + group.path);
        const auto add = [&](const std::string& id, const std::string& text, Chart chart) {
            charts.push_back({group.scene, group.path, id, text, std::move(chart)});
        };
        const bool timed = std::any_of(group.rows.begin(), group.rows.end(),
                                       [](const Row* row) { return !std::isnan(summary(*row, Measure::total_ms)); });
        const bool has_curve = group.rows.front()->frames.size() > 1;
        if (timed) {
            add(stem + "-trade-off-wrong", "Lower and further left is better. The grey line joins the Pareto points.",
                trade_off(group, Measure::wrong));
            add(stem + "-trade-off-coverage",
                "Higher and further left is better. The oracle is the best that the budget could find.",
                trade_off(group, Measure::coverage));
        }
        add(stem + "-drawn-wrong", "The same over what is drawn, which no machine changes. V itself is perfect's dot.",
            trade_off(group, Measure::wrong, Measure::rendered));
        if (std::count_if(group.rows.begin(), group.rows.end(),
                          [](const Row* row) { return summary(*row, Measure::tested) > 0; }) > 1)
            add(stem + "-tested-wrong",
                "Over how much is held against what is drawn; methods that test nothing are not here.",
                trade_off(group, Measure::wrong, Measure::tested));
        if (std::any_of(group.rows.begin(), group.rows.end(),
                        [](const Row* row) { return mean_of(*row, &Values::wrong_at)[0] >= 0; }))
            add(stem + "-distance-wrong", "Where pixels are wrong: the gem finds them far from the eye.",
                wrong_by_distance(group));
        if (!has_curve) continue;
        for (const auto& rows : by_method(group))
            if (rows.front()->method.variant == "published")
                add(stem + "-found-published" +
                        (rows.front()->method.tessellation == Tessellation::delaunay
                             ? ""
                             : "-" + std::string(word(rows.front()->method.tessellation))),
                    "Like TVCG figs. 10 and 11: an order that estimates visibility well keeps the shape "
                    "of the exact curve.",
                    found_per_frame(group, rows));
        add(stem + "-frames-wrong", "Like TVCG figs. 10 to 12: each method at its largest budget.",
            per_frame(group, Measure::wrong));
        add(stem + "-frames-coverage",
            "By count. Beside the wrong pixels it shows where count and picture disagree (TVCG fig. 15).",
            per_frame(group, Measure::coverage));
        if (timed) {
            Chart times = per_frame(group, Measure::total_ms);
            times.log_y = true;
            times.is_share = false;
            add(stem + "-frames-time", "Time follows what the frame renders.", std::move(times));
        }
        std::vector<const WrongFlight*> wrong_flights;
        for (const WrongFlight& flight : results.wrong_flights)
            if (flight.scene == group.scene && flight.path == group.path) wrong_flights.push_back(&flight);
        if (!wrong_flights.empty())
            add(stem + "-frames-wrong-budget",
                "Near the dashed line is a budget that spends no more than the frame needs; below it, too many pixels "
                "are wrong.",
                wrong_budget_per_frame(group, wrong_flights));
        std::vector<const TimedFlight*> flights;
        for (const TimedFlight& flight : results.flights)
            if (flight.scene == group.scene && flight.path == group.path) flights.push_back(&flight);
        if (!flights.empty())
            add(stem + "-frames-budget",
                "A budget in time follows the machine and the view: how many primitives it came to in each frame.",
                budget_per_frame(group, flights));
    }
    return charts;
}

}  // namespace sightline::lab
