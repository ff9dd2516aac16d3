// Rows of a study made by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/measure/results.h"

namespace sightline::lab::test {

inline Row report_row(const std::string& scene, const std::string& method, const std::string& budget, double ms,
                      double wrong, double coverage, std::size_t frames = 3) {
    Row row;
    row.scene = scene;
    row.path = "test";
    row.method = parse_method(method);
    row.approximate = budget != "unlimited";
    row.budget = budget;
    row.primitives = 1000;
    row.cells = 50;
    row.reference = "item buffer 1024x768";
    for (std::size_t i = 0; i < frames; ++i) {
        row.frames.push_back(static_cast<std::uint32_t>(i));
        Values v;
        v[Measure::total_ms] = ms;
        v[Measure::draw_ms] = ms / 2;
        v[Measure::upload_ms] = ms / 8;
        v[Measure::wrong] = wrong;
        v[Measure::coverage] = coverage;
        v[Measure::visible] = 100 + 10 * static_cast<double>(i);
        v[Measure::budget] = 50;
        v[Measure::oracle] = 1;
        row.values.push_back(v);
    }
    return row;
}

inline Results results_of(std::vector<Row> rows) {
    Study study;
    study.scenes = {"city"};
    Results results{conditions_here(study_json(study), "a renderer"), std::move(rows)};
    results.conditions.date = "2000-01-01";
    return results;
}

}  // namespace sightline::lab::test
