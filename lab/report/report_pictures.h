// Which frames a report shows: the worst of each method, and what stands against the papers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "lab/report/claims.h"
#include "lab/report/study_charts.h"
#include "lab/report/wrong_pictures.h"

namespace sightline::lab {

struct ReportPictures {
    std::vector<FramePicture> worst;             ///< for each scene, path and approximate method, at its middle budget
    std::map<std::size_t, FramePicture> claims;  ///< by index of the claims with a row_to_show
    std::vector<NamedChart> keys{};              ///< key against visible share (key_chart.h)
};

/// The frames with the most wrong pixels. `claims` are those of the same results; scenes are read and tessellated anew.
ReportPictures draw_report_pictures(const Results& results, const std::vector<Claim>& claims, const Study& study,
                                    const std::filesystem::path& folder, LabGraphics& graphics);

}  // namespace sightline::lab
