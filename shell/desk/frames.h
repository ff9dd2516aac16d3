// The lane of frames of a method that knows the frame before (core/session/session.h): kept, gone through, and how much
// each changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shell/desk/workbench.h"

namespace sightline {

/// Frames of the lane, the one at hand, and those after it that were left by stepping back: how many there are, and
/// which is at hand. None where the method keeps no lane.
struct FrameCount {
    std::size_t frames = 0, here = 0;
};
template <int D>
FrameCount count_frames(const Workbench<D>& bench);

/// What a frame's run did otherwise than that of the frame before.
struct FrameChange {
    std::optional<std::uint32_t> boxes;  ///< found in another state; nothing: there is no frame before it here
    std::string technique{};             ///< that a method by viewpoint did; empty for other methods
    bool operator==(const FrameChange&) const = default;
};

/// Of each of the last `most` frames that count_frames counts. Runs them all.
template <int D>
std::vector<FrameChange> frame_changes(const Workbench<D>& bench, std::size_t most);

/// Runs the frame again with a recording, after those before it; those after it stay to be gone to. Throws InputError
/// for one that is not there.
template <int D>
void step_into_frame(Workbench<D>& bench, std::size_t frame);

/// The frame at hand is the one before what comes next. Throws InputError for a method that does not look at it.
template <int D>
void keep_frame(Workbench<D>& bench);

template <int D>
void forget_frames(Workbench<D>& bench);

}  // namespace sightline
