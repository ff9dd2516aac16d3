// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/portals.h"

#include "core/methods/portals/portal_run.h"
#include "core/methods/portals/pvs_run.h"

namespace sightline {

namespace {

template <int D>
Method<D> room_method(std::string_view id, std::string_view title, std::string_view sentence,
                      std::function<std::unique_ptr<Run<D>>(const Problem<D>&)> start, Kind pops,
                      void (*prepare)(const Problem<D>&)) {
    Method<D> row{id, title, sentence, std::move(start), pops, prepare};
    row.needs.cells = false;
    row.needs.boxes = true;
    row.budgeted = false;
    row.promise = Misses::none;
    row.compared = false;  // without rooms it is view culling
    return row;
}

/// The sets of the rooms that hold the eye.
template <int D>
void make_sets(const Problem<D>& problem) {
    const auto graph = room_graph(problem);
    const auto sets = room_sets(problem);
    const RoomsAt at = rooms_at(problem.scene->rooms, problem.view.eye);
    if (!at.outside)
        for (const std::uint32_t room : at.rooms) sets->of(*problem.scene, *graph, room);
}

}  // namespace

template <int D>
std::vector<Method<D>> portal_methods() {
    return {room_method<D>(
                "portals", "portals",
                "from room to room through portals, each of which narrows the window (Luebke and Georges 1995)",
                [](const Problem<D>& problem) { return std::make_unique<PortalRun<D>>(problem); }, Kind::portal,
                [](const Problem<D>& problem) { room_graph(problem); }),
            room_method<D>(
                "pvs", "potentially visible set",
                "what can be seen from any point of the eye's room, found beforehand (Airey 1990, Teller 1991)",
                [](const Problem<D>& problem) { return std::make_unique<PvsRun<D>>(problem); }, Kind::region,
                make_sets<D>)};
}

template std::vector<Method<2>> portal_methods<2>();
template std::vector<Method<3>> portal_methods<3>();

}  // namespace sightline
