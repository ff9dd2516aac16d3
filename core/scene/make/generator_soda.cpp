// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/base/float_value.h"
#include "core/scene/make/generators.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/office_floor.h"
#include "core/scene/make/plots.h"
#include "core/scene/make/route.h"
#include "core/scene/plan_rooms.h"

namespace sightline {

namespace {

/// In polygons. One wing with its four outer faces, floor and ceiling has the 1,685 of the paper when the two halves of
/// the ways through its exits are joined.
constexpr std::size_t floor_and_ceiling = 2, outer_face_polygons = 6, joined_at_exits = 4 * 3;
constexpr std::size_t whole_wing = 1'685 + joined_at_exits - floor_and_ceiling - 4 * outer_face_polygons;
/// About half of a wing that has corridors and a lecture hall only: with fewer left, the number is met better without.
constexpr std::size_t least_of_wing = 55;

using Place2 = std::pair<int, int>;

constexpr std::array<Place2, 4> wing_neighbours = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};  // as WingSide

/// Where the wings stand, the first at the origin, and how many polygons each is to have.
struct WingPlan {
    std::vector<std::pair<Plot, std::size_t>> wings;
    std::set<Place2> taken;

    bool has(const Plot& wing, std::size_t side) const {
        return taken.contains({wing.x + wing_neighbours[side].first, wing.y + wing_neighbours[side].second});
    }
};

WingPlan plan_wings(std::size_t polygons) {
    WingPlan plan;
    std::size_t left = polygons;
    // Faces toward the outside are paid for by the wings that have them; a new wing also covers some.
    for (const Plot& plot : plots_by_distance(polygons / whole_wing + 2)) {
        const Plot wing{plot.x + 1, plot.y + 1};
        std::size_t covered = 0;
        for (std::size_t side = 0; side < 4; ++side) covered += plan.has(wing, side);
        const std::size_t shell = outer_face_polygons * (4 - covered), saved = outer_face_polygons * covered;
        const std::size_t around = floor_and_ceiling + shell;
        if (left + saved < around + least_of_wing) break;
        const std::size_t here = std::min(left + saved - around, whole_wing);
        plan.wings.emplace_back(wing, here);
        plan.taken.insert({wing.x, wing.y});
        left = left + saved - around - here;
    }
    return plan;
}

void build_wing(Model& m, const OfficeWing& wing, const Vec<2>& corner) {
    constexpr double z = office_height, door = office_door_height;
    const Placement outer = m.plan;
    m.plan.origin += corner;
    const auto upright = [&](const Vec<2>& p, const Vec<2>& q, double low, double high) {
        m.polygon({{p.x, p.y, low}, {q.x, q.y, low}, {q.x, q.y, high}, {p.x, p.y, high}});
    };
    for (const WallFace& face : wing.faces)
        for_pieces(
            face, [&](const Vec<2>& p, const Vec<2>& q) { upright(p, q, 0, z); },
            [&](const Vec<2>& p, const Vec<2>& q) { upright(p, q, door, z); });
    for (const DoorWay& way : wing.doorways) {
        const Vec<2> a = way.left, b = way.right, c = b + way.through, d = a + way.through;
        upright(a, d, 0, door);
        upright(c, b, 0, door);
        m.polygon({{a.x, a.y, door}, {d.x, d.y, door}, {c.x, c.y, door}, {b.x, b.y, door}});
    }
    for (const FloorBox& box : wing.boxes) {
        m.plan = {box.frame.origin + corner, box.frame.cos, box.frame.sin};
        m.box({box.low.x, box.low.y, box.foot}, {box.high.x, box.high.y, box.top}, box.sides);
    }
    m.plan = outer;
}

void add_rooms(Rooms<3>& rooms, const OfficeWing& wing, const Vec<2>& corner) {
    for (const FreeFloor& floor : wing.free) {
        const Vec<2> low = glm::min(floor.a, floor.b) + corner, high = glm::max(floor.a, floor.b) + corner;
        rooms.all.push_back({floor.name + (" " + std::to_string(rooms.all.size())),
                             {{float_value(low.x), float_value(low.y), 0},
                              {float_value(high.x), float_value(high.y), float_value(floor.top)}}});
    }
}

/// The end of a way out that lies outside.
Portal<3> outer_portal(const Box<3>& box, std::uint32_t room, const DoorWay& way) {
    const int axis = way.through.x == 0 ? 1 : 0, other = 1 - axis;
    const double end = way.through[axis] > 0 ? box.max[axis] : box.min[axis];
    Portal<3> portal{{room, none}, {4, box.min}};
    for (Vec<3>& corner : portal.corners) corner[axis] = end;
    portal.corners[1][other] = portal.corners[2][other] = box.max[other];
    portal.corners[2].z = portal.corners[3].z = box.max.z;
    return portal;
}

void draw_wing(Sketch& sketch, const OfficeWing& wing) {
    const auto line = [&](const Vec<2>& p, const Vec<2>& q) { sketch.line(p, q); };
    for (const WallFace& face : wing.faces) for_pieces(face, line, [](const Vec<2>&, const Vec<2>&) {});
    for (const DoorWay& way : wing.doorways) {
        line(way.left, way.left + way.through);
        line(way.right + way.through, way.right);
    }
    for (const FloorBox& box : wing.boxes) {
        if (box.top < 1.7) continue;  // the plan is of what stands as high as the eye
        const std::array<Vec<2>, 4> corners = {box.frame.at(box.low), box.frame.at({box.high.x, box.low.y}),
                                               box.frame.at(box.high), box.frame.at({box.low.x, box.high.y})};
        constexpr std::array<unsigned, 4> sides = {front_side, right_side, back_side, left_side};
        for (std::size_t i = 0; i < 4; ++i)
            if (box.sides & sides[i]) line(corners[i], corners[(i + 1) % 4]);
    }
}

/// Out of a room, along its corridor and on from crossing to crossing, always in the middle of free ground.
std::vector<Vec<2>> way_through(const OfficeWing& wing, Random random) {
    constexpr double sway = 0.2, wanted = 30;
    std::vector<Vec<2>> way;
    int x = 1, y = 1, came = 4;  // the crossing, and the side of it that the way comes from
    const auto crossing = [&](int i, int j) { return Vec<2>(corridors_x[i], corridors_y[j]); };
    if (wing.doors.empty()) {
        way.push_back(crossing(x, y));
    } else {
        const DoorWay& door = wing.doors[random.below(wing.doors.size())];
        const Vec<2> middle = (door.left + door.right) * 0.5;
        const Vec<2> inward = door.through / std::sqrt(glm::dot(door.through, door.through));
        way = {middle + 1.7 * inward, middle + 0.1 * inward, middle - inward};
        const Vec<2> at = way.back();
        // The next crossing on one of the two sides; none that is just beside the door.
        std::vector<std::array<int, 3>> next;
        const bool along_x = std::abs(inward.y) > 0.5;
        const double here = along_x ? at.x : at.y;
        const auto& across = along_x ? corridors_y : corridors_x;
        const auto& ahead = along_x ? corridors_x : corridors_y;
        const double line = along_x ? at.y : at.x;
        const int row = line < (across[0] + across[1]) / 2 ? 0 : line < (across[1] + across[2]) / 2 ? 1 : 2;
        for (int i = 0; i < 3; ++i) {
            const bool on = std::abs(ahead[i] - here) > 2;
            if (on && ahead[i] > here && (i == 0 || ahead[i - 1] <= here + 2))
                next.push_back({i, along_x ? 3 : 0, row});
            if (on && ahead[i] < here && (i == 2 || ahead[i + 1] >= here - 2))
                next.push_back({i, along_x ? 1 : 2, row});
        }
        const auto& [i, side, j] = next[random.below(next.size())];
        x = along_x ? i : j, y = along_x ? j : i, came = side;
        stroll(way, crossing(x, y), random, sway);
    }
    for (double length = 0; length < wanted;) {
        const int side = static_cast<int>(random.below(4));
        const auto [dx, dy] = wing_neighbours[static_cast<std::size_t>(side)];
        if (side == came || x + dx < 0 || x + dx > 2 || y + dy < 0 || y + dy > 2) continue;
        x += dx, y += dy, came = (side + 2) % 4;
        stroll(way, crossing(x, y), random, sway);
        length += std::abs(dx * 23.0 + dy * 15.0);
    }
    return way;
}

}  // namespace

std::vector<Primitive<2>> soda(std::uint64_t seed) {
    Sketch sketch;
    draw_wing(sketch, office_wing(Plot{0, 0}.random(seed), whole_wing));
    for (const WingSide side : {WingSide::south, WingSide::east, WingSide::north, WingSide::west})
        draw_wing(sketch, outer_face(side, true, true));
    return sketch.segments;
}

Rooms<2> rooms_of_soda(std::uint64_t seed) {
    OfficeWing wing = office_wing(Plot{0, 0}.random(seed), whole_wing);
    wing.boxes.clear();
    Sketch walls, openings;
    draw_wing(walls, wing);
    for (const WingSide side : {WingSide::south, WingSide::east, WingSide::north, WingSide::west}) {
        const OfficeWing face = outer_face(side, true, true);
        draw_wing(walls, face);
        openings.line(face.faces[0].a, face.faces[0].b);
    }
    return plan_rooms(walls.segments, openings.segments);
}

namespace generate {

Generated soda(std::uint64_t seed, std::size_t triangles) {
    Model model;
    const WingPlan plan = plan_wings(triangles / 2);
    Generated made;
    for (const auto& [at, polygons] : plan.wings) {
        const Vec<2> low = wing_size * Vec<2>(at.x, at.y), high = low + wing_size;
        const OfficeWing wing = office_wing(at.random(seed), polygons);
        build_wing(model, wing, low);
        add_rooms(made.rooms, wing, low);
        model.polygon({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}});
        constexpr double z = office_height;
        model.polygon({{low.x, low.y, z}, {low.x, high.y, z}, {high.x, high.y, z}, {high.x, low.y, z}});
        if (made.paths.empty()) made.paths.push_back(on_foot("walk", way_through(wing, Random(seed)), 480));
    }
    std::vector<std::pair<DoorWay, std::uint32_t>> exits;
    for (const auto& [at, polygons] : plan.wings) {
        const Vec<2> corner = wing_size * Vec<2>(at.x, at.y);
        for (std::size_t side = 0; side < 4; ++side)
            if (!plan.has(at, side)) {
                const OfficeWing face = outer_face(static_cast<WingSide>(side), !plan.has(at, (side + 3) % 4),
                                                   !plan.has(at, (side + 1) % 4));
                build_wing(model, face, corner);
                add_rooms(made.rooms, face, corner);
                exits.push_back({face.doorways[0], static_cast<std::uint32_t>(made.rooms.all.size() - 1)});
            }
    }
    made.rooms.portals = portals_between(made.rooms.all);
    for (const auto& [way, room] : exits)
        made.rooms.portals.push_back(outer_portal(made.rooms.all[room].shape, room, way));
    made.triangles = std::move(model.triangles);
    const double middle = corridors_y[1];
    made.paths.push_back(on_foot("line", std::array{Vec<2>(19, middle), Vec<2>(35, middle)}, 320));
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace generate

}  // namespace sightline
