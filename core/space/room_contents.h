// Which primitives the rooms of a scene hold, and which can be seen from outside of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/scene/scene.h"

namespace sightline {

/// Rows of primitives, rising: one for each room, of all that meets its closure or may; and one for the outside, of all
/// but what lies in a single room and has no part in its border. 3D: a one-sided triangle in a room's border whose
/// front looks into the room is the room's alone.
struct RoomContents {
    std::vector<std::uint32_t> begin{0};
    std::vector<std::uint32_t> primitives;
    std::vector<std::uint8_t> outside;  ///< per primitive: 1 for those of the last row

    std::uint32_t rooms() const { return static_cast<std::uint32_t>(begin.size() - 2); }
    /// `room` = rooms(): the outside.
    std::span<const std::uint32_t> of(std::uint32_t room) const {
        return std::span(primitives).subspan(begin[room], begin[room + 1] - begin[room]);
    }
    std::size_t memory_bytes() const {
        return (begin.capacity() + primitives.capacity()) * sizeof(std::uint32_t) + outside.capacity();
    }
};

template <int D>
RoomContents room_contents(const Scene<D>& scene);

}  // namespace sightline
