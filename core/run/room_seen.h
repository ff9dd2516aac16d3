// What a method that goes from room to room has seen of one so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/run/step.h"
#include "core/scene/view.h"

namespace sightline {

/// A room may be seen through several windows.
template <int D>
struct RoomSeen {
    std::uint32_t room = 0;
    CellState state{};  ///< projected: looked into; enqueued: it waits
    bool whole = true;  ///< all of it, whatever the window
    View<D> window{};   ///< else through that
};

}  // namespace sightline
