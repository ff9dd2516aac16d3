// What `lab viewpoint` found: text, tables of frames, charts, claims, and a page of documentation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "lab/report/chart.h"
#include "lab/report/claims.h"
#include "lab/viewpoint/viewpoint_results.h"

namespace sightline::lab {

/// For the console, with all figures.
std::string viewpoint_text(const ViewpointResults& results);

/// t_select / valid_frames + t(α) against t(β) of the technique, as measured over the path.
std::string inequality_text(const ViewpointWalk& walk, std::size_t technique);

Chart walk_chart(const ViewpointScene& scene);
/// Bytes of the table by its intervals of directions, and what merging would leave of them.
Chart table_sizes_chart(const ViewpointScene& scene);

/// What the paper says of its campus (DAS 6), judged on each scene: shapes, not figures.
std::vector<Claim> viewpoint_claims(const ViewpointResults& results);

/// viewpoint.txt, and of each scene SCENE-PATH.csv, SCENE-PATH-frames.{svg,pdf,png,gp}, and -sizes where there are
/// some. Throws WorkError.
void write_viewpoint(const ViewpointResults& results, const std::filesystem::path& folder, const ChartFormat& format);

/// As a page of documentation, its charts in images/ beside it. `command` is what made it. Throws WorkError.
void write_viewpoint_page(const ViewpointResults& results, const std::string& command,
                          const std::filesystem::path& file, const ChartFormat& format);

}  // namespace sightline::lab
