// What the methods of the family know of a scene's rooms before the first view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/run/problem.h"
#include "core/space/facing.h"
#include "core/space/room_contents.h"

namespace sightline {

template <int D>
struct RoomGraph {
    RoomContents contents;
    std::vector<std::uint32_t> begin{0};  ///< of each room's row, that of the outside last
    std::vector<std::uint32_t> portals;
    std::vector<Vec<D>> middles;  ///< a point inside each room
    /// Around so many primitives each, one after the other in a row of `contents`: block_size.
    std::vector<Box<D>> blocks;
    std::vector<std::uint32_t> first_block{0};  ///< per row and one more
    std::vector<Box<D>> groups;                 ///< around so many blocks of a row each: blocks_a_group
    std::vector<std::uint32_t> first_group{0};  ///< per row and one more
    FacingPlanes facing;                        ///< 3D: in the order of contents.primitives

    static constexpr std::uint32_t block_size = 16, blocks_a_group = 16;

    std::uint32_t outside() const { return contents.rooms(); }
    std::span<const std::uint32_t> portals_of(std::uint32_t room) const {
        return std::span(portals).subspan(begin[room], begin[room + 1] - begin[room]);
    }
    /// Where one comes to; outside() for what is none of the rooms.
    std::uint32_t beyond(const Portal<D>& portal, std::uint32_t room) const {
        const std::uint32_t from = room == outside() ? none : room;
        const std::uint32_t to = portal.rooms[0] == from ? portal.rooms[1] : portal.rooms[0];
        return to == none ? outside() : to;
    }
    std::size_t memory_bytes() const {
        return contents.memory_bytes() + (begin.capacity() + portals.capacity()) * sizeof(std::uint32_t) +
               middles.capacity() * sizeof(Vec<D>) + (blocks.capacity() + groups.capacity()) * sizeof(Box<D>) +
               (first_block.capacity() + first_group.capacity()) * sizeof(std::uint32_t) + facing.memory_bytes();
    }
};

template <int D>
RoomGraph<D> make_room_graph(const Scene<D>& scene);

/// Of the problem's scene, made once. Throws InputError where its rooms are not sound.
template <int D>
std::shared_ptr<const RoomGraph<D>> room_graph(const Problem<D>& problem);

/// "room hall", "the outside"
template <int D>
std::string room_words(const Rooms<D>& rooms, std::uint32_t room) {
    return room < rooms.all.size() ? "room " + rooms.all[room].name : "the outside";
}

}  // namespace sightline
