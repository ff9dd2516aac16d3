// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/campus_building.h"

#include <algorithm>
#include <array>

#include "core/scene/make/building.h"

namespace sightline {

namespace {

constexpr double door_side = 0.875, window_side = 1.25, row_depth = 5, hallway = 2.25;
constexpr double sill_height = 0.875, lintel_height = 2.25, roof_slab = 0.25;
static_assert(roof_slab <= campus_facade && campus_step <= campus_facade, "what lies between rooms and the outside");

/// Of a straight wall from a to b, whose front is on the right of the way.
struct PlanWall {
    Vec<2> a, b;
    double length() const { return std::abs(b.x - a.x) + std::abs(b.y - a.y); }
    Vec<2> along() const { return (b - a) / length(); }
};

/// Clockwise from above, so that their fronts are inside.
std::array<PlanWall, 4> walls_of(const RoomPlan& r) {
    const Vec<2> sw(r.x0, r.y0), se(r.x1, r.y0), ne(r.x1, r.y1), nw(r.x0, r.y1);
    return {{{nw, ne}, {ne, se}, {se, sw}, {sw, nw}}};
}

void sort_once(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Where a wall is cut from foot to top: at its ends and at both sides of each opening.
std::vector<double> cuts_of(const PlanWall& wall, std::span<const WallOpening> openings) {
    std::vector<double> cuts{0, wall.length()};
    for (const WallOpening& o : openings) cuts.insert(cuts.end(), {o.x0, o.x1});
    sort_once(cuts);
    return cuts;
}

/// The face of a wall from z0 to z1. Openings do not overlap, and where one stands over another both are as wide.
/// Neighbouring pieces share all corners on the line between them.
void wall_sheet(Model& m, const PlanWall& wall, double z0, double z1, std::span<const WallOpening> openings) {
    const std::vector<double> cuts = cuts_of(wall, openings);
    const Vec<2> along = wall.along();
    const auto heights_at = [&](double x) {
        std::vector<double> heights{z0, z1};
        for (const WallOpening& o : openings)
            if (o.x0 <= x && x <= o.x1)
                for (const double z : {o.z0, o.z1})
                    if (z0 < z && z < z1) heights.push_back(z);
        sort_once(heights);
        return heights;
    };
    const auto point = [&](double x, double z) {
        const Vec<2> p = wall.a + along * x;
        return Vec<3>(p.x, p.y, z);
    };
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double x0 = cuts[i - 1], x1 = cuts[i];
        const std::vector<double> left = heights_at(x0), right = heights_at(x1);
        std::vector<double> solid{z0};  // from where and to where
        std::vector<WallOpening> here;
        for (const WallOpening& o : openings)
            if (o.x0 <= x0 && x1 <= o.x1) here.push_back(o);
        std::sort(here.begin(), here.end(), [](const auto& a, const auto& b) { return a.z0 < b.z0; });
        for (const WallOpening& o : here) solid.insert(solid.end(), {o.z0, o.z1});
        solid.push_back(z1);
        for (std::size_t k = 0; k < solid.size(); k += 2) {
            const double low = solid[k], high = solid[k + 1];
            if (!(high > low)) continue;
            std::size_t l = 0, r = 0;
            while (left[l] < low) ++l;
            while (right[r] < low) ++r;
            while (left[l] < high || right[r] < high) {
                const bool go_right = right[r] < high && (left[l] == high || right[r + 1] <= left[l + 1]);
                if (go_right)
                    m.triangle(point(x0, left[l]), point(x1, right[r]), point(x1, right[r + 1]));
                else
                    m.triangle(point(x0, left[l]), point(x1, right[r]), point(x0, left[l + 1]));
                ++(go_right ? r : l);
            }
        }
    }
}

/// A flat polygon between walls, from its middle to all corners that the walls have at this height.
void level_sheet(Model& m, const std::vector<Vec<2>>& clockwise, double z, bool up) {
    Box<2> box;
    for (const Vec<2>& p : clockwise) box.add(p);
    const Vec<2> middle = dyadic(box.centre());
    for (std::size_t i = 0; i < clockwise.size(); ++i) {
        const Vec<2>&p = clockwise[i], &q = clockwise[(i + 1) % clockwise.size()];
        const Vec<3> a(middle.x, middle.y, z), b(p.x, p.y, z), c(q.x, q.y, z);
        if (up)
            m.triangle(a, c, b);
        else
            m.triangle(a, b, c);
    }
}

void add_corners(std::vector<Vec<2>>& ring, const PlanWall& wall, std::span<const WallOpening> openings) {
    const std::vector<double> cuts = cuts_of(wall, openings);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) ring.push_back(wall.a + wall.along() * cuts[i]);
}

/// On a storey, whose floor is at z.
WallOpening opening_in(const PlanWall& wall, const PlannedOpening& o, int storey, double z) {
    const Vec<2> along = wall.along();
    const double x0 = glm::dot(o.p - wall.a, along), x1 = glm::dot(o.q - wall.a, along);
    const bool to_floor = o.gap == PlannedGap::door || (o.gap == PlannedGap::exit && storey == 0);
    const double top = o.gap == PlannedGap::door ? campus_door : lintel_height;
    return {std::min(x0, x1), std::max(x0, x1), to_floor ? z : z + sill_height, z + top};
}

bool lies_on(const PlanWall& wall, const PlannedOpening& o) {
    if (wall.a.x == wall.b.x) return o.p.x == wall.a.x && o.q.x == wall.a.x;
    return o.p.y == wall.a.y && o.q.y == wall.a.y;
}

double floor_of(int storey) { return campus_step + campus_storey * storey; }

void add_storey(NamedModel& made, const BuildingPlan& plan, int storey, NumberedNames& names) {
    const double z = floor_of(storey), top = z + campus_storey;
    const auto first = static_cast<std::uint32_t>(made.rooms.all.size());
    for (std::uint32_t i = 0; i < plan.rooms.size(); ++i) {
        const PlannedRoom& room = plan.rooms[i];
        std::vector<Vec<2>> ring;
        const auto each_wall = [&](auto use) {
            for (const PlanWall& wall : walls_of(room.floor)) {
                std::vector<WallOpening> openings;
                for (const PlannedOpening& o : plan.openings)
                    if ((o.from == i || o.to == i) && lies_on(wall, o))
                        openings.push_back(opening_in(wall, o, storey, z));
                use(wall, openings);
            }
        };
        made.add(names.next("walls"), [&](Model& m) {
            each_wall([&](const PlanWall& wall, const std::vector<WallOpening>& openings) {
                wall_sheet(m, wall, z, top, openings);
                add_corners(ring, wall, openings);
            });
        });
        made.add(names.next("floor"), [&](Model& m) { level_sheet(m, ring, z, true); });
        made.add(names.next("ceiling"), [&](Model& m) { level_sheet(m, ring, top, false); });
        Box<3> box;
        box.add(made.model.at({room.floor.x0, room.floor.y0, z}));
        box.add(made.model.at({room.floor.x1, room.floor.y1, top}));
        const std::string number = std::to_string(100 * (storey + 1) + static_cast<int>(i));
        made.rooms.all.push_back(
            {names.place + (room.use == PlannedUse::corridor ? "corridor " : "room ") + number, box});
    }
    for (const PlannedOpening& o : plan.openings) {
        const PlanWall wall{o.p, o.q};
        const WallOpening gap = opening_in(wall, o, storey, z);
        const auto corner = [&](const Vec<2>& p, double height) { return made.model.at({p.x, p.y, height}); };
        made.rooms.portals.push_back(
            {{first + o.from, o.to == none ? none : first + o.to},
             {corner(o.p, gap.z0), corner(o.q, gap.z0), corner(o.q, gap.z1), corner(o.p, gap.z1)}});
    }
}

/// The outside: four walls, what is between their openings and those of the rooms, the roof, and the base: closed but
/// for the openings.
void add_outside(NamedModel& made, const BuildingPlan& plan, NumberedNames& names) {
    constexpr double t = campus_facade;
    const double top = floor_of(plan.storeys) + roof_slab;
    std::vector<Vec<2>> ring;  // counter-clockwise
    const std::array<Vec<2>, 4> corners = {
        {{-t, -t}, {plan.length + t, -t}, {plan.length + t, plan.depth + t}, {-t, plan.depth + t}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const PlanWall outer{corners[side], corners[(side + 1) % 4]};
        const Vec<2> along = outer.along(), inward(-along.y, along.x);
        const PlanWall inner{outer.a + (along + inward) * t, outer.b + (inward - along) * t};
        std::vector<WallOpening> openings;
        for (const PlannedOpening& o : plan.openings)
            if (o.to == none && lies_on(inner, o))
                for (int storey = 0; storey < plan.storeys; ++storey)
                    openings.push_back(opening_in(outer, o, storey, floor_of(storey)));
        made.add(names.next("facade"), [&](Model& m) {
            wall_sheet(m, outer, 0, top, openings);
            const Inside frame(m, {outer.a.x, outer.a.y, 0}, 90.0 * static_cast<double>(side));
            for (const WallOpening& o : openings) {  // as in wall_panel, but that each has a sill
                m.polygon({{o.x0, 0, o.z0}, {o.x0, t, o.z0}, {o.x0, t, o.z1}, {o.x0, 0, o.z1}});
                m.polygon({{o.x1, 0, o.z0}, {o.x1, 0, o.z1}, {o.x1, t, o.z1}, {o.x1, t, o.z0}});
                m.polygon({{o.x0, 0, o.z1}, {o.x0, t, o.z1}, {o.x1, t, o.z1}, {o.x1, 0, o.z1}});
                m.polygon({{o.x0, 0, o.z0}, {o.x1, 0, o.z0}, {o.x1, t, o.z0}, {o.x0, t, o.z0}});
            }
        });
        const Inside frame(made.model, {outer.a.x, outer.a.y, 0}, 90.0 * static_cast<double>(side));
        for (const WallOpening& o : openings) {
            const double middle = (o.x0 + o.x1) / 2;
            if (o.z0 == campus_step)
                made.add(names.next("canopy"), [&](Model& m) {
                    m.box({o.x0 - 0.3, -1.25, o.z1 + 0.1}, {o.x1 + 0.3, 0, o.z1 + 0.2}, all_sides & ~back_side);
                });
            else
                made.add(names.next("window"), [&](Model& m) {
                    m.box({middle - 0.03, 0.1, o.z0}, {middle + 0.03, 0.16, o.z1},
                          left_side | right_side | front_side | back_side);
                    m.box({o.x0 - 0.06, -0.08, o.z0 - 0.06}, {o.x1 + 0.06, 0, o.z0 - 0.01}, all_sides & ~back_side);
                });
        }
        add_corners(ring, outer, openings);
    }
    std::reverse(ring.begin(), ring.end());
    made.add(names.next("roof"), [&](Model& m) { level_sheet(m, ring, top, true); });
    made.add(names.next("base"), [&](Model& m) { level_sheet(m, ring, 0, false); });
    for (double x = 3; x + 3 < plan.length; x += 6)
        made.add(names.next("vent"), [&](Model& m) {
            m.box({x, plan.depth / 2 - 0.6, top}, {x + 1.2, plan.depth / 2 + 0.6, top + 0.9}, all_sides & ~bottom_side);
        });
}

}  // namespace

BuildingPlan offices_plan(Random& random, double length, int rooms, int storeys) {
    BuildingPlan plan{length, 2 * row_depth + hallway, storeys, {}, {}};
    const double south = row_depth, north = row_depth + hallway, middle = row_depth + hallway / 2;
    plan.rooms.push_back({{0, south, length, north}, PlannedUse::corridor});
    plan.openings.push_back({0, none, {0, middle - window_side / 2}, {0, middle + window_side / 2}, PlannedGap::exit});
    plan.openings.push_back(
        {0, none, {length, middle - window_side / 2}, {length, middle + window_side / 2}, PlannedGap::exit});
    for (const bool back : {false, true}) {
        const double wall = back ? north : south, outside = back ? plan.depth : 0;
        double x0 = 0;
        for (int i = 0; i < rooms; ++i) {
            const double share = length * (i + 1) / rooms;
            const double x1 = i + 1 == rooms ? length : dyadic(share + random.uniform(-0.3, 0.3));
            const auto room = static_cast<std::uint32_t>(plan.rooms.size());
            const double width = x1 - x0, door = dyadic((x0 + x1) / 2 + random.uniform(-0.25, 0.25));
            static constexpr PlannedUse uses[] = {PlannedUse::office, PlannedUse::office, PlannedUse::office,
                                                  PlannedUse::seminar, PlannedUse::laboratory};
            const PlannedUse use = uses[random.below(5)];
            plan.rooms.push_back({{x0, back ? north : 0, x1, back ? plan.depth : south}, use, door, back});
            const auto gap = [&](double x, double y, double wide, std::uint32_t to, PlannedGap kind) {
                plan.openings.push_back({room, to, {x - wide / 2, y}, {x + wide / 2, y}, kind});
            };
            gap(door, wall, door_side, 0, PlannedGap::door);
            for (const double share_of_width : {0.27, 0.73})
                gap(dyadic(x0 + share_of_width * width), outside, window_side, none, PlannedGap::window);
            const bool beside = random.below(4) == 0;
            if (beside && i > 0) {  // a door to the room before, near the corridor
                const double y = back ? wall + 1 : wall - 1;
                plan.openings.push_back(
                    {room, room - 1, {x0, y - door_side / 2}, {x0, y + door_side / 2}, PlannedGap::door});
            }
            x0 = x1;
        }
    }
    return plan;
}

BuildingPlan hall_plan(double length, double depth, PlannedUse use) {
    BuildingPlan plan{length, depth, 1, {}, {}};
    plan.rooms.push_back({{0, 0, length, depth}, use, length / 2, true});
    const auto gap = [&](double x, double y, PlannedGap kind) {
        plan.openings.push_back({0, none, {x - window_side / 2, y}, {x + window_side / 2, y}, kind});
    };
    gap(length / 2, 0, PlannedGap::exit);
    gap(length / 2, depth, PlannedGap::exit);
    for (double x = 2; x + 1 < length; x += 4)
        if (std::abs(x - length / 2) > 1.5) gap(x, 0, PlannedGap::window);
    return plan;
}

void campus_walls(Sketch& sketch, Rooms<2>& rooms, const BuildingPlan& plan, const std::string& place) {
    const auto gaps_in = [&](const PlanWall& wall, bool outside_only) {
        std::vector<Opening> gaps;
        for (const PlannedOpening& o : plan.openings) {
            if (!lies_on(wall, o) || (outside_only && o.to != none)) continue;
            const WallOpening gap = opening_in(wall, o, 0, 0);
            if (gap.x0 > 0 && gap.x1 < wall.length()) gaps.push_back({(gap.x0 + gap.x1) / 2, gap.x1 - gap.x0});
        }
        std::sort(gaps.begin(), gaps.end(), [](const Opening& a, const Opening& b) { return a.at < b.at; });
        return gaps;
    };
    const auto first = static_cast<std::uint32_t>(rooms.all.size());
    for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
        const PlannedRoom& room = plan.rooms[i];
        for (const PlanWall& wall : walls_of(room.floor)) {
            const bool upright = wall.a.x == wall.b.x;
            // Of two rooms beside each other the first has the wall between them, and a corridor has only its ends.
            if (room.use == PlannedUse::corridor ? !upright : upright && wall.a.x == room.floor.x0 && wall.a.x > 0)
                continue;
            sketch.wall(wall.a, wall.b, gaps_in(wall, false));
        }
        const RoomPlan& r = room.floor;
        const std::string kind = room.use == PlannedUse::corridor ? "corridor " : "room ";
        rooms.all.push_back({place + kind + std::to_string(100 + i),
                             {sketch.frame.at({r.x0, r.y0}), sketch.frame.at({r.x1, r.y0}),
                              sketch.frame.at({r.x1, r.y1}), sketch.frame.at({r.x0, r.y1})}});
    }
    for (const PlannedOpening& o : plan.openings)
        rooms.portals.push_back(
            {{first + o.from, o.to == none ? none : first + o.to}, {sketch.frame.at(o.p), sketch.frame.at(o.q)}});
    constexpr double t = campus_facade;
    for (const PlanWall& wall : walls_of({0, 0, plan.length, plan.depth})) {
        const Vec<2> along = wall.along(), outward(-along.y, along.x);
        const std::vector<Opening> gaps = gaps_in(wall, true);
        std::vector<Opening> outer = gaps;
        for (Opening& gap : outer) gap.at += t;
        sketch.wall(wall.a + (outward - along) * t, wall.b + (outward + along) * t, outer);
        for (const Opening& gap : gaps)
            for (const double side : {-0.5, 0.5}) {
                const Vec<2> p = wall.a + along * (gap.at + side * gap.width);
                sketch.line(p, p + outward * t);
            }
    }
}

void campus_shell(NamedModel& made, const BuildingPlan& plan, NumberedNames& names) {
    for (int storey = 0; storey < plan.storeys; ++storey) add_storey(made, plan, storey, names);
    add_outside(made, plan, names);
}

}  // namespace sightline
