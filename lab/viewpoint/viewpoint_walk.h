// A path, frame by frame: the choice by viewpoint beside each of its techniques alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/measure/frame_clock.h"
#include "core/methods/by_viewpoint/viewpoint_run.h"
#include "core/truth/id_image.h"

namespace sightline::lab {

/// Medians; upload and drawing without those of an empty frame.
struct FrameTime {
    double cull_ms = 0, draw_ms = 0;
    std::uint32_t drawn = 0;
    double wrong = 0;  ///< the share of wrong pixels; where levels stand in, by objects
    double ms() const { return cull_ms + draw_ms; }
};

/// Where an eye is, as the paper tells its regimes apart (DAS 6).
enum class EyePlace : std::uint8_t { inside, street, above };
inline constexpr auto eye_place_words = std::to_array<std::string_view>({"inside", "street", "above"});

/// inside: in a room; above: higher than all that stands there; street: else.
EyePlace eye_place(const Scene<3>& scene, const Vec<3>& eye);

struct WalkFrame {
    std::vector<FrameTime> alone;  ///< each technique
    FrameTime adaptive;
    FrameTime everything;  ///< all primitives, without any technique
    EyePlace where = EyePlace::street;
    std::uint32_t technique = 0, entry = 0;  ///< what was done, and what the table says
    std::size_t place = 0;
    double predicted_ms = 0;  ///< of what was done, by the entry
    /// The least of those alone: with hindsight.
    double best_ms() const;
    std::size_t best() const;
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
    /// Of a number of each frame; NaN where no frame is of that place.
    double mean_at(EyePlace where, const std::function<double(const WalkFrame&)>& value) const;
    std::size_t frames_at(EyePlace where) const;
    double r2() const;  ///< predicted by entries against measured
};

/// What the frames are drawn with.
struct WalkTools {
    TimeDrawing time_drawing;
    DrawIds draw_ids;  ///< for the exact image; empty: in software
    int repeats = 3;
    std::function<bool(std::size_t)> go_on;  ///< asked after each frame, with how many there are; false ends it early
};

/// In every frame all of them, one after the other; each goes on from its own frame before.
ViewpointWalk walk_by_viewpoint(const Variant<3>& by_viewpoint, const ViewpointTable<3>& table,
                                const std::shared_ptr<const Scene<3>>& scene, const CellComplex<3>& cells,
                                const std::vector<View<3>>& views, const WalkTools& tools);

}  // namespace sightline::lab
