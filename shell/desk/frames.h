// The lane of frames of a method that knows the frame before (core/session/session.h): kept, gone through, and how much
// each changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
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

/// Of each of the last `most` frames that count_frames counts, how many boxes its run found in another state than in
/// the frame before; nothing for one without a frame before it here. Runs them all.
template <int D>
std::vector<std::optional<std::uint32_t>> frame_changes(const Workbench<D>& bench, std::size_t most);

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
