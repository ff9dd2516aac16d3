// The campus as a plan at the height of an eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/campus_plan.h"
#include "core/scene/make/generators.h"

namespace sightline {

namespace {

/// Along both side walls of a room; the way from the door and the part near it stay free.
void furnish_on_plan(Sketch& sketch, Random random, const PlannedRoom& room) {
    const RoomPlan& r = room.floor;
    if (room.use == PlannedUse::corridor) return;
    if (room.use == PlannedUse::hall) {
        for (double y = r.y0 + 3.5; y + 1.2 < r.y1; y += 2.4)
            for (const double x : {r.x0 + 1, (r.x0 + r.x1) / 2 + 1.5})
                sketch.box(x, y, x + r.width() / 2 - 2.5, y + 0.5);
        return;
    }
    // Where y = 0 is the wall to the corridor.
    const auto box = [&](double x0, double y0, double x1, double y1) {
        if (room.back)
            sketch.box(x0, r.y0 + y0, x1, r.y0 + y1);
        else
            sketch.box(x0, r.y1 - y1, x1, r.y1 - y0);
    };
    for (const bool right : {false, true}) {
        const double wall = right ? r.x1 - 0.1 : r.x0 + 0.1, way = right ? -1 : 1;
        const auto against = [&](double deep, double y0, double y1) {
            const double other = wall + way * deep;
            box(std::min(wall, other), y0, std::max(wall, other), y1);
        };
        const double cupboard = random.uniform(0.35, 0.5);
        against(cupboard, 1.7, 2.4);
        if (random.below(3) > 0)
            against(0.8, 2.7, 4.2);
        else
            against(0.4, 2.6, 4.4);
    }
}

template <typename Use>
void each_site(std::uint64_t seed, Use use) {
    for (std::size_t i = 0; i < campus_sites().size(); ++i) {
        const CampusSite& site = campus_sites()[i];
        const int number = static_cast<int>(i);
        Random random = campus_stream(seed, 1, number);
        use(site_plan(site, random), turned(site.corner, 90.0 * site.quarter_turns), number);
    }
}

}  // namespace

std::vector<Primitive<2>> campus(std::uint64_t seed) {
    Sketch sketch;
    Rooms<2> unused;
    each_site(seed, [&](const BuildingPlan& plan, const Placement& frame, int number) {
        sketch.frame = frame;
        campus_walls(sketch, unused, plan, "");
        for (std::size_t i = 0; i < plan.rooms.size(); ++i)
            furnish_on_plan(sketch, campus_stream(seed, 10 + number, static_cast<int>(i)), plan.rooms[i]);
    });
    for (const OutdoorThing& thing : outdoor_things(seed)) {
        sketch.frame = turned(thing.at, thing.degrees);
        Random own = thing.own;
        if (thing.kind == OutdoorKind::car) sketch.box(-2.1, -0.8, 2.1, 0.8);
        if (thing.kind == OutdoorKind::lamp) sketch.ring({0, 0}, 0.1, 4);
        if (thing.kind == OutdoorKind::oak || thing.kind == OutdoorKind::fir)
            sketch.ring({0, 0}, own.uniform(0.8, 1.5), 7);
        if (thing.kind == OutdoorKind::hedge) sketch.box(-1.5, -0.4, 1.5, 0.4);
    }
    return sketch.segments;
}

Rooms<2> rooms_of_campus(std::uint64_t seed) {
    Rooms<2> rooms;
    each_site(seed, [&](const BuildingPlan& plan, const Placement& frame, int number) {
        Sketch sketch;
        sketch.frame = frame;
        campus_walls(sketch, rooms, plan, "building " + std::to_string(number + 1) + " / ");
    });
    return rooms;
}

}  // namespace sightline
