// How many cells a scene needs, as charts and a page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/cells/cells.h"
#include "lab/report/chart.h"

namespace sightline::lab {

/// charts/ and cells.html; `measure` and `within` are those of knee(). Throws WorkError.
void write_cells_report(const std::vector<CellsCurve>& curves, Measure measure, double within,
                        const std::filesystem::path& folder, const ChartFormat& format = {});

/// The knee as a settings file: method, tessellation, error bound and budget, and why.
std::string knee_settings(const CellsCurve& curve, Measure measure, double within);

/// The same of any point; `of_what` it is nearly as good, in words.
std::string point_settings(const CellsCurve& curve, std::size_t point, Measure measure, double within,
                           const std::string& of_what);

}  // namespace sightline::lab
