// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/stability/stability_charts.h"

#include <algorithm>
#include <map>

#include "lab/report/method_looks.h"

namespace sightline::lab {

namespace {

Series exact_set() { return {"exact set", {{136, 136, 136}, guide_dash}, Series::Shown::line, 3, {}, {}}; }

/// Over the distance that the eye moves, and grey what the exact set explains.
Chart eye_chart(const StabilityGroup& group, bool coverage) {
    Chart chart;
    chart.x = "distance, of the scene's longest side";
    chart.y = coverage ? "mean |coverage - coverage'|, %" : "1 - Jaccard of the rendered sets, %";
    chart.log_x = true;
    const MethodLooks looks = MethodLooks::of(group.rows);
    std::map<std::string, std::size_t> of_method;
    Series exact = exact_set();
    for (const StabilityRow* row : group.rows) {
        if (row->disturbance != Disturbance::eye) continue;
        const auto [at, is_new] = of_method.try_emplace(method_text(row->method), chart.series.size());
        if (is_new) chart.series.push_back(looks.series(row->method));
        const double y = coverage ? row->coverage_change : 1 - row->jaccard;
        chart.series[at->second].points.push_back({row->amount, 100 * y});
        if (at->second == 0) exact.points.push_back({row->amount, 100 * (1 - row->visible_jaccard)});
    }
    if (!coverage) chart.series.push_back(std::move(exact));
    return chart;
}

/// Coverage while the eye passes through the plane of a wall.
Chart grazing_chart(const StabilityGroup& group) {
    Chart chart;
    chart.x = "degrees off the plane of the wall";
    chart.y = "coverage, %";
    const MethodLooks looks = MethodLooks::of(group.rows);
    for (const StabilityRow* row : group.rows) {
        if (row->disturbance != Disturbance::grazing) continue;
        Series s = looks.series(row->method);
        for (std::size_t i = 0; i < row->sweep.size(); ++i)
            s.points.push_back({1 - row->amount * static_cast<double>(row->sweep.size() - 1 - i), 100 * row->sweep[i]});
        chart.series.push_back(std::move(s));
    }
    return chart;
}

/// Popping from frame to frame, and grey what the exact set itself changes.
Chart path_chart(const StabilityGroup& group, const Results& along_path) {
    Chart chart;
    chart.x = "frame of the path";
    chart.y = "popping, %";
    Series exact = exact_set();
    std::vector<const Row*> rows;
    for (const Row& row : along_path.rows)
        if (row.scene == group.scene && row.path == group.path && row.budget == group.budget) rows.push_back(&row);
    const MethodLooks looks = MethodLooks::of(rows);
    for (const Row* const of : rows) {
        const Row& row = *of;
        Series s = looks.series(row.method);
        const bool first = exact.points.empty();
        for (std::size_t i = 1; i < row.frames.size(); ++i) {
            const auto frame = static_cast<double>(row.frames[i]);
            s.points.push_back({frame, 100 * row.values[i][Measure::pop]});
            if (first) exact.points.push_back({frame, 100 * row.values[i][Measure::visible_change]});
        }
        chart.series.push_back(std::move(s));
    }
    chart.series.push_back(std::move(exact));
    return chart;
}

}  // namespace

std::vector<StabilityGroup> stability_groups(const std::vector<StabilityRow>& rows) {
    std::vector<StabilityGroup> groups;
    for (const StabilityRow& row : rows) {
        auto at = std::find_if(groups.begin(), groups.end(), [&](const StabilityGroup& group) {
            return group.scene == row.scene && group.path == row.path && group.budget == row.budget;
        });
        if (at == groups.end()) at = groups.insert(at, {row.scene, row.path, row.budget, {}});
        at->rows.push_back(&row);
    }
    return groups;
}

std::vector<NamedChart> stability_charts(const StabilityGroup& group, const Results& along_path) {
    std::vector<NamedChart> charts;
    const std::string where = group.scene + ", path " + group.path + ", budget " + group.budget + ": ";
    const auto add = [&](const std::string& id, const std::string& title, const std::string& text, Chart chart) {
        const bool any = std::any_of(chart.series.begin(), chart.series.end(),
                                     [](const Series& series) { return !series.points.empty(); });
        if (!any) return;
        chart.title = where + title;
        charts.push_back({group.scene, group.path,
                          file_stem("stability-" + group.scene + "-" + group.path + "-" + group.budget + "-" + id),
                          text, std::move(chart)});
    };
    add("rendered", "change of what is rendered when the eye moves",
        "Grey is what the exact set itself changes: a line above it is instability.", eye_chart(group, false));
    add("coverage", "change of coverage when the eye moves", "How far a small step of the eye changes what is found.",
        eye_chart(group, true));
    add("grazing", "past a wall",
        "The eye turns about the middle of the largest primitive it sees, through its plane at 0°, where v · n is 0: a "
        "jump there is instability.",
        grazing_chart(group));
    add("path", "popping along the path",
        "Visible before and after, rendered in one of them only. Grey is by how much the exact set changed.",
        path_chart(group, along_path));
    return charts;
}

}  // namespace sightline::lab
