// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/room_graph.h"

namespace sightline {

namespace {

template <int D>
void make_blocks(const Scene<D>& scene, RoomGraph<D>& graph) {
    for (std::uint32_t room = 0; room <= graph.outside(); ++room) {
        const auto row = graph.contents.of(room);
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i % (RoomGraph<D>::block_size * RoomGraph<D>::blocks_a_group) == 0) graph.groups.emplace_back();
            if (i % RoomGraph<D>::block_size == 0) graph.blocks.emplace_back();
            for (const Vec<D>& corner : scene.primitives[row[i]]) {
                graph.blocks.back().add(corner);
                graph.groups.back().add(corner);
            }
        }
        graph.first_group.push_back(static_cast<std::uint32_t>(graph.groups.size()));
        graph.first_block.push_back(static_cast<std::uint32_t>(graph.blocks.size()));
    }
    if constexpr (D == 3) graph.facing = FacingPlanes(scene, graph.contents.primitives);
}

}  // namespace

template <int D>
RoomGraph<D> make_room_graph(const Scene<D>& scene) {
    const Rooms<D>& rooms = scene.rooms;
    check_rooms(rooms, scene.id);
    RoomGraph<D> graph;
    graph.contents = room_contents(scene);
    std::vector<std::vector<std::uint32_t>> rows(rooms.all.size() + 1);
    for (std::uint32_t i = 0; i < rooms.portals.size(); ++i)
        for (const std::uint32_t room : rooms.portals[i].rooms)
            rows[room == none ? graph.outside() : room].push_back(i);
    for (const auto& row : rows) {
        graph.portals.insert(graph.portals.end(), row.begin(), row.end());
        graph.begin.push_back(static_cast<std::uint32_t>(graph.portals.size()));
    }
    for (const Room<D>& room : rooms.all) graph.middles.push_back(middle_of(room));
    make_blocks(scene, graph);
    return graph;
}

template <int D>
std::shared_ptr<const RoomGraph<D>> room_graph(const Problem<D>& problem) {
    return problem.cells->made->template of<RoomGraph<D>>("rooms", [&] { return make_room_graph(*problem.scene); });
}

#define SIGHTLINE_INSTANTIATE(D)                               \
    template RoomGraph<D> make_room_graph<D>(const Scene<D>&); \
    template std::shared_ptr<const RoomGraph<D>> room_graph<D>(const Problem<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
