// Measures one scene along its path with every method and budget of a study.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/measure/frame_before.h"
#include "core/measure/frame_clock.h"
#include "core/truth/id_image.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/results.h"

namespace sightline::lab {

/// The values of one frame: one per method and budget, methods outermost.
struct FrameResult {
    std::uint32_t frame = 0;  ///< index into LabScene::frames
    std::vector<Values> values;
};

/// What a measurement is given and whom it tells.
struct Instruments {
    DrawIds draw_ids{};
    TimeDrawing time_drawing{};  ///< empty: drawing is not timed
    /// Frames that an earlier run finished, by index; they are not measured again.
    std::function<std::optional<FrameResult>(std::uint32_t frame)> finished{};
    /// After each frame, and before the first; false stops.
    std::function<bool(const FrameResult& frame)> frame_done{};
};

/// A row per method and budget, methods outermost; fewer frames where frame_done stopped it. Numbers that need no clock
/// are made on all cores; then times are taken, one after the other. Methods that the dimension does not have are left
/// out. Throws as the instruments do.
template <int D>
std::vector<Row> measure_path(const LabScene<D>& lab, const Study& study, const Instruments& instruments);

}  // namespace sightline::lab
