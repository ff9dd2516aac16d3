// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/room_graph.h"

namespace sightline {

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
