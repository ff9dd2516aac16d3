// A path, frame by frame: the choice by viewpoint beside each of its techniques alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/measure/frame_clock.h"
#include "core/methods/by_viewpoint/viewpoint_run.h"

namespace sightline::lab {

/// Medians; upload and drawing without those of an empty frame.
struct FrameTime {
    double cull_ms = 0, draw_ms = 0;
    std::uint32_t drawn = 0;
    double ms() const { return cull_ms + draw_ms; }
};

struct WalkFrame {
    std::vector<FrameTime> alone;  ///< each technique
    FrameTime adaptive;
    std::uint32_t technique = 0, entry = 0;  ///< what was done, and what the table says
    std::size_t place = 0;
    double predicted_ms = 0;  ///< of what was done, by the entry
    /// The least of those alone: with hindsight.
    double best_ms() const;
};

struct ViewpointWalk {
    std::vector<WalkFrame> frames;
    double empty_ms = 0;    ///< an empty frame's upload and drawing, the median
    double look_up_ns = 0;  ///< of one look-up in the table
    std::size_t switches = 0;

    double adaptive_ms() const;  ///< means over the frames
    double hindsight_ms() const;
    double alone_ms(std::size_t technique) const;
    double worst_adaptive_ms() const;
    double worst_alone_ms(std::size_t technique) const;
    std::size_t best_alone() const;  ///< by its mean
};

/// In every frame all of them, one after the other, `repeats` times; each goes on from its own frame before.
ViewpointWalk walk_by_viewpoint(const Method<3>& by_viewpoint, const Parameters& parameters,
                                const ViewpointTable<3>& table, const std::shared_ptr<const Scene<3>>& scene,
                                const CellComplex<3>& cells, const std::vector<View<3>>& views,
                                const TimeDrawing& time_drawing, int repeats,
                                const std::function<bool(std::size_t)>& go_on);

}  // namespace sightline::lab
