// report.html: one file to hand out, with every chart and picture in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/report/chart.h"
#include "lab/report/claims.h"
#include "lab/report/report_pictures.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

/// charts/ID.gp, .svg and .png, and report.html, which reads the SVGs and the pictures. `claims` are those of the
/// results. Throws WorkError, also when gnuplot is not there.
void write_report(const Results& results, const std::vector<Claim>& claims, const ReportPictures& pictures,
                  const std::filesystem::path& folder, const ChartFormat& format = {});

/// Which method and budget has the fewest wrong pixels within so many milliseconds a frame; nullptr: none is that fast.
const Row* best_within(const Group& group, double ms);

}  // namespace sightline::lab
