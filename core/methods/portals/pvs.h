// The potentially visible set of each room: what can be seen from any point of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "core/methods/portals/room_graph.h"

namespace sightline {

/// What of a room can be seen.
struct SeenRoom {
    std::uint32_t room = 0;            ///< RoomGraph::outside() for what is none
    std::uint32_t portal = none;       ///< the last of the first way that leads there; none: the room itself
    std::uint32_t begin = 0, end = 0;  ///< of SeenFromRoom::primitives
};
struct SeenFromRoom {
    std::vector<SeenRoom> rooms;            ///< the nearest in portals first
    std::vector<std::uint32_t> primitives;  ///< each once; rising in a room
    std::uint32_t ways = 0;                 ///< sequences of portals that a line stabs
    std::uint32_t cut_short = 0;            ///< of them, those of which only the last portal was kept

    std::span<const std::uint32_t> of(const SeenRoom& room) const {
        return std::span(primitives).subspan(room.begin, room.end - room.begin);
    }
    std::size_t memory_bytes() const {
        return rooms.capacity() * sizeof(SeenRoom) + primitives.capacity() * sizeof(std::uint32_t);
    }
};

/// All that a line through a sequence of portals from the room can meet. 2D: exact in that a primitive counts only if a
/// line stabs all portals and it; what hides it is not asked. 3D: of such a line the shadows in the three coordinate
/// planes stab those of the portals, so the set is larger. A portal that was reached in many ways is once taken by
/// itself, as if one could stand at it, which leaves no way out.
template <int D>
SeenFromRoom seen_from_room(const Scene<D>& scene, const RoomGraph<D>& graph, std::uint32_t room);

/// One for each room, made when it is first asked for. Any thread may ask.
template <int D>
class RoomSets {
public:
    explicit RoomSets(std::size_t rooms) : slots_(std::make_unique<Slot[]>(rooms)), count_(rooms) {}

    const SeenFromRoom& of(const Scene<D>& scene, const RoomGraph<D>& graph, std::uint32_t room) const {
        Slot& slot = slots_[room];
        std::call_once(slot.once, [&] {
            slot.seen = seen_from_room(scene, graph, room);
            slot.is_made = true;
        });
        return slot.seen;
    }
    std::size_t count() const { return count_; }

private:
    struct Slot {
        std::once_flag once;
        SeenFromRoom seen;
        bool is_made = false;
    };
    std::unique_ptr<Slot[]> slots_;
    std::size_t count_;
};

template <int D>
std::shared_ptr<const RoomSets<D>> room_sets(const Problem<D>& problem);

}  // namespace sightline
