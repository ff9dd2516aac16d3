// How well a key tells what is seen: each popped cell's key against its visible share, as a scatter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/measure/frame_numbers.h"
#include "core/truth/id_image.h"
#include "lab/measure/lab_scene.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

/// A chart for each method of the group that orders cells, of the frame in the middle of its path at the method's
/// largest budget; none where fewer than three cells were popped. At most 4000 dots, evenly over the steps. `lab` has
/// the frames of the rows.
template <int D>
std::vector<NamedChart> key_charts(const LabScene<D>& lab, const Group& group, const DrawIds& draw_ids);

/// The dots of one method, and the correlation of all of them in the title.
Chart key_chart(const std::string& heading, const KeysAndShares& popped, const Series& look);

}  // namespace sightline::lab
