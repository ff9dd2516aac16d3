// Stability as files: a table for programs, curves and a page for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/measure/results.h"
#include "lab/report/chart.h"
#include "lab/stability/stability.h"

namespace sightline::lab {

/// A line per row, columns as StabilityRow.
std::string stability_csv(const std::vector<StabilityRow>& rows);

/// An array of objects, fields as the columns, on one line; and the other way round.
std::string stability_rows_json(const std::vector<StabilityRow>& rows);
std::vector<StabilityRow> read_stability_rows(const std::string& json);

/// {"format": "sightline-stability", "version": 1, "conditions": {…}, "rows": […]}
std::string stability_json(const Conditions& conditions, const std::vector<StabilityRow>& rows);

/// stability.json, stability.csv, charts/ and stability.html. `along_path`: the rows of a study of the same scenes, for
/// popping against what the exact set itself changes. Throws WorkError.
void write_stability(const Conditions& conditions, const std::vector<StabilityRow>& rows, const Results& along_path,
                     const std::filesystem::path& folder, const ChartFormat& format = {});

}  // namespace sightline::lab
