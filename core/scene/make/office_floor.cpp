// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/office_floor.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sightline {

namespace {

constexpr double wall_between = 0.125, wall_to_corridor = 0.1875, half_outer_wall = 0.125;
constexpr double door_width = 0.875, exit_width = 1.5, corridor_width = 2;
constexpr double narrowest_room = 2.6;
/// Four faces, a door in two of them, its sides and top, and its leaf.
constexpr std::size_t polygons_of_room = 17;
/// What a second door adds, two columns, and a shelf.
constexpr std::size_t polygons_of_door = 13, polygons_of_columns = 8, polygons_of_shelf = 4;

enum class RowUse { offices, labs, hall };

/// Rooms side by side along a corridor. In its frame the rooms begin at y = 0 and reach to y = depth, and the wall to
/// the corridor is before them, its face to the corridor going from face_from to face_to.
struct OfficeRow {
    Placement frame;
    double length, depth, face_from, face_to;
    RowUse use;
    std::size_t rooms = 0;
    double degrees = 0;

    double doors_from() const { return std::max(face_from, 0.0); }
    double doors_to() const { return std::min(face_to, length); }
    /// How many rooms it gets, compared with others.
    double share() const { return (doors_to() - doors_from()) * (use == RowUse::offices ? 1 : 0.35); }
    std::size_t most_rooms() const { return static_cast<std::size_t>((doors_to() - doors_from()) / narrowest_room); }
};

WallFace face_of(const Placement& frame, const Vec<2>& a, const Vec<2>& b, std::vector<Opening> doors = {}) {
    return {frame.at(a), frame.at(b), std::move(doors)};
}

/// From y0 to y1 of the frame.
DoorWay doorway_of(const Placement& frame, double at, double width, double y0, double y1) {
    const double left = at - width / 2, right = at + width / 2;
    return {frame.at({left, y0}), frame.at({right, y0}), frame.at({left, y1}) - frame.at({left, y0})};
}

void add_doorway(OfficeWing& wing, const DoorWay& way) {
    wing.doorways.push_back(way);
    wing.free.push_back({"doorway", way.left, way.right + way.through, office_door_height});
}

OfficeRow row_of(const Vec<2>& origin, double degrees, double length, double depth, double from, double to,
                 RowUse use = RowUse::offices) {
    return {turned(origin, degrees), length, depth, from, to, use, 0, degrees};
}

// Where rooms and corridors begin and end.
constexpr double outer = half_outer_wall, strip = 5.125;
constexpr double west_in = corridors_x[0] + corridor_width / 2, south_in = corridors_y[0] + corridor_width / 2;
constexpr double mid_w = corridors_x[1] - corridor_width / 2, mid_e = corridors_x[1] + corridor_width / 2;
constexpr double mid_s = corridors_y[1] - corridor_width / 2, mid_n = corridors_y[1] + corridor_width / 2;
constexpr double t = wall_to_corridor;

/// The rows at the outer walls; those at the north and the south hold the corners.
void add_outer_rows(std::vector<OfficeRow>& rows) {
    const double w = wing_size.x, h = wing_size.y;
    const double wide = mid_w - t - outer, high = mid_s - t - (strip + t), corner = strip + t - outer;
    rows.push_back(row_of({mid_w - t, strip}, 180, wide, strip - outer, -t, wide - corner));
    rows.push_back(row_of({w - outer, strip}, 180, wide, strip - outer, corner, wide + t));
    rows.push_back(row_of({outer, h - strip}, 0, wide, strip - outer, corner, wide + t));
    rows.push_back(row_of({mid_e + t, h - strip}, 0, wide, strip - outer, -t, wide - corner));
    rows.push_back(row_of({strip, strip + t}, 90, high, strip - outer, 0, high + t));
    rows.push_back(row_of({strip, mid_n + t}, 90, high, strip - outer, -t, high));
    rows.push_back(row_of({w - strip, mid_s - t}, 270, high, strip - outer, -t, high));
    rows.push_back(row_of({w - strip, h - strip - t}, 270, high, strip - outer, 0, high + t));
}

/// One of the four blocks between ring and cross, `low` and `high` being its faces to the corridors.
void add_inner_rows(OfficeWing& wing, std::vector<OfficeRow>& rows, Random& random, const Vec<2>& low,
                    const Vec<2>& high, int kind) {
    const double length = high.x - low.x - 2 * t, deep = high.y - low.y - 2 * t, face = length + t;
    wing.faces.push_back(face_of({}, {high.x, low.y}, high));
    wing.faces.push_back(face_of({}, {low.x, high.y}, low));
    const double split = dyadic(0.5 * (deep - wall_between) + random.uniform(-1, 1));
    const auto south = [&](double depth, RowUse use) {
        return row_of(low + Vec<2>(t, t), 0, length, depth, -t, face, use);
    };
    const auto north = [&](double depth, RowUse use) {
        return row_of(high - Vec<2>(t, t), 180, length, depth, -t, face, use);
    };
    if (kind == 0) {  // a lecture hall, stairs and lifts
        rows.push_back(south(deep, RowUse::hall));
        wing.faces.push_back(face_of({}, high, {low.x, high.y}));
    } else {  // two rows back to back
        rows.push_back(south(split, kind == 1 ? RowUse::labs : RowUse::offices));
        rows.push_back(north(deep - wall_between - split, kind == 3 ? RowUse::labs : RowUse::offices));
    }
}

/// Rooms as wide as this have two doors.
constexpr double two_doors = 9;

/// About how many polygons the row's rooms will be.
std::size_t cost_of(const OfficeRow& row) {
    const double width = (row.doors_to() - row.doors_from()) / static_cast<double>(row.rooms);
    const std::size_t door = width > two_doors ? polygons_of_door : 0;
    const std::size_t columns = row.use == RowUse::labs ? polygons_of_columns : 0;
    return row.rooms * (polygons_of_room + door + columns);
}

/// How many rooms each row gets: one after another for so many polygons. Where there are few, some rows get none.
void share_out(std::vector<OfficeRow>& rows, std::size_t polygons) {
    while (true) {
        OfficeRow* next = nullptr;  // the one that is farthest behind
        std::size_t cost = 0;
        for (OfficeRow& row : rows) {
            if (row.rooms > 0) cost += cost_of(row);
            if (row.use != RowUse::hall && row.rooms < row.most_rooms() &&
                (!next ||
                 static_cast<double>(row.rooms) * next->share() < static_cast<double>(next->rooms) * row.share()))
                next = &row;
        }
        if (!next) return;
        const std::size_t before = next->rooms > 0 ? cost_of(*next) : 0;
        ++next->rooms;
        if (cost - before + cost_of(*next) <= polygons) continue;
        --next->rooms;
        return;
    }
}

struct OfficeRoom {
    double x0, x1;                ///< in the row's frame
    double doors_from, doors_to;  ///< where its doors may be
    int doors;
};

std::vector<OfficeRoom> rooms_of(const OfficeRow& row, Random& random) {
    if (row.use == RowUse::hall) {  // stairs behind it; the rest are lifts, which are solid
        const double stairs = row.length - 6;
        return {{0, stairs - wall_between, 0, stairs - wall_between, 2},
                {stairs, stairs + 3.2, stairs, stairs + 3.2, 1}};
    }
    if (row.rooms == 0) return {};
    std::vector<double> cuts{0};
    for (std::size_t i = 0; i < row.rooms; ++i) cuts.push_back(cuts.back() + random.uniform(0.75, 1.35));
    const double from = row.doors_from(), scale = (row.doors_to() - from) / cuts.back();
    std::vector<OfficeRoom> rooms;
    for (std::size_t i = 0; i < row.rooms; ++i) {
        const double left = dyadic(from + scale * cuts[i]) + (i > 0 ? wall_between / 2 : 0);
        const double right = dyadic(from + scale * cuts[i + 1]) - (i + 1 < row.rooms ? wall_between / 2 : 0);
        // The first and the last reach to the ends of the row.
        rooms.push_back({i == 0 ? 0 : left, i + 1 == row.rooms ? row.length : right, left, right,
                         right - left > two_doors ? 2 : 1});
    }
    return rooms;
}

/// A box in the row's frame, standing at `at` and turned by more degrees.
FloorBox box_in(const OfficeRow& row, const Vec<2>& at, double degrees, const Vec<2>& low, const Vec<2>& high,
                double top, unsigned sides) {
    const double foot = sides & bottom_side ? 0.01 : 0;
    return {turned(row.frame.at(at), row.degrees + degrees), low, high, foot, top, sides};
}

void add_room(OfficeWing& wing, std::vector<FloorBox>& shelves, const OfficeRow& row, const OfficeRoom& room,
              std::vector<Opening>& corridor, Random& random) {
    std::vector<Opening> inside;  // of the face that is walked from x1 to x0
    const double share = (room.doors_to - room.doors_from) / room.doors;
    for (int i = 0; i < room.doors; ++i) {
        // Free of the walls on both sides, so that the leaf has a place.
        const double from = room.doors_from + share * i;
        const double at = dyadic(random.uniform(from + 0.95, from + share - 0.65));
        corridor.push_back({at - row.face_from, door_width});
        inside.insert(inside.begin(), {room.x1 - at, door_width});
        const DoorWay door = doorway_of(row.frame, at, door_width, -t, 0);
        add_doorway(wing, door);
        wing.doors.push_back(door);
        wing.boxes.push_back(
            box_in(row, {at - door_width / 2, 0}, random.uniform(80, 112), {0.03, 0}, {0.9, 0.04}, 2.05, all_sides));
    }
    const auto face = [&](const Vec<2>& a, const Vec<2>& b, std::vector<Opening> doors) {
        wing.faces.push_back(face_of(row.frame, a, b, std::move(doors)));
    };
    wing.free.push_back({"room", row.frame.at({room.x0, 0}), row.frame.at({room.x1, row.depth}), office_height});
    face({room.x0, 0}, {room.x0, row.depth}, {});
    face({room.x0, row.depth}, {room.x1, row.depth}, {});
    face({room.x1, row.depth}, {room.x1, 0}, {});
    face({room.x1, 0}, {room.x0, 0}, inside);

    const unsigned upright = left_side | right_side | front_side | back_side;
    const double width = room.x1 - room.x0;
    if (row.use == RowUse::hall && room.doors == 2) {  // steps that rise toward the back, with a way up on both sides
        for (int i = 0; i < 4; ++i)
            wing.boxes.push_back(box_in(row, {room.x0, 0}, 0, {1.5, 5 + 2.0 * i},
                                        {width - 1.5, i == 3 ? row.depth : 7 + 2.0 * i}, 0.3 * (i + 1),
                                        all_sides & ~unsigned{bottom_side | back_side}));
    } else if (row.use == RowUse::hall) {  // the wall between two flights of stairs
        wing.boxes.push_back(
            box_in(row, {room.x0 + width / 2, 4}, 0, {-0.1, 0}, {0.1, row.depth - 6}, office_height, upright));
    } else if (row.use == RowUse::labs && width > 5) {  // columns
        for (const double share_of_width : {0.3, 0.7})
            wing.boxes.push_back(box_in(row, {room.x0 + share_of_width * width, 0.6 * row.depth}, 0, {-0.25, -0.25},
                                        {0.25, 0.25}, office_height, upright));
    }
    if (row.use == RowUse::hall) return;
    for (double x = room.x0 + 0.2; x + 1.2 < room.x1; x += 1.35)
        shelves.push_back(
            box_in(row, {x, row.depth}, 0, {0, -0.4}, {1.2, 0}, 2, left_side | right_side | front_side | top_side));
}

/// The exit at the end of a corridor of the cross: in the frame, the corridor comes from y < 0 and ends at y = 0.
void add_exit(OfficeWing& wing, const Placement& frame) {
    const double half = corridor_width / 2, deep = strip + t - outer;
    wing.faces.push_back(face_of(frame, {-half, 0}, {half, 0}, {{half, exit_width}}));
    add_doorway(wing, doorway_of(frame, 0, exit_width, 0, half_outer_wall));
    // The walls on both sides of the corridor, as deep as the outer rows.
    wing.free.push_back({"exit", frame.at({-half, -deep}), frame.at({half, 0}), office_height});
    wing.faces.push_back(face_of(frame, {-half, -deep}, {-half, 0}));
    wing.faces.push_back(face_of(frame, {half, 0}, {half, -deep}));
}

std::array<std::pair<Vec<2>, double>, 4> exits() {
    const double w = wing_size.x, h = wing_size.y, x = corridors_x[1], y = corridors_y[1];
    return {{{{x, outer}, 180}, {{w - outer, y}, 270}, {{x, h - outer}, 0}, {{outer, y}, 90}}};
}

/// Crossings, and what lies between them.
void add_corridors(OfficeWing& wing) {
    constexpr double half = corridor_width / 2;
    const auto crossing = [](std::size_t i, std::size_t j) { return Vec<2>(corridors_x[i], corridors_y[j]); };
    const auto add = [&](const char* name, const Vec<2>& a, const Vec<2>& b) {
        wing.free.push_back({name, a, b, office_height});
    };
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            add("crossing", crossing(i, j) - half, crossing(i, j) + half);
            if (i < 2) add("corridor", crossing(i, j) + Vec<2>(half, -half), crossing(i + 1, j) + Vec<2>(-half, half));
            if (j < 2) add("corridor", crossing(i, j) + Vec<2>(-half, half), crossing(i, j + 1) + Vec<2>(half, -half));
        }
}

}  // namespace

std::size_t OfficeWing::polygons() const {
    std::size_t count = 3 * doorways.size();
    for (const WallFace& face : faces) count += 1 + 2 * face.doors.size();
    for (const FloorBox& box : boxes)
        for (unsigned side = left_side; side <= top_side; side *= 2) count += (box.sides & side) != 0;
    return count;
}

OfficeWing office_wing(Random random, std::size_t polygons) {
    OfficeWing wing;
    for (const auto& [at, degrees] : exits()) add_exit(wing, turned(at, degrees));
    add_corridors(wing);
    std::vector<OfficeRow> rows;
    add_outer_rows(rows);
    const Vec<2> inner(mid_w - west_in, mid_s - south_in), low(west_in, south_in), high(mid_e, mid_n);
    const std::uint64_t first = random.below(4);
    for (std::uint64_t i = 0; i < 4; ++i) {
        const Vec<2> corner(i % 2 == 0 ? low.x : high.x, i / 2 == 0 ? low.y : high.y);
        add_inner_rows(wing, rows, random, corner, corner + inner, static_cast<int>((i + first) % 4));
    }
    // Rooms make nearly all of it, and shelves what is left. The hall has three doors, four steps and a wall.
    const std::size_t without_rooms = wing.polygons() + rows.size() + 8 + 3 * polygons_of_door + 16 + 4;
    share_out(rows, polygons > without_rooms ? (polygons - without_rooms) * 93 / 100 : 0);
    std::vector<FloorBox> shelves;
    for (const OfficeRow& row : rows) {
        std::vector<Opening> corridor;
        for (const OfficeRoom& room : rooms_of(row, random)) add_room(wing, shelves, row, room, corridor, random);
        wing.faces.push_back(face_of(row.frame, {row.face_from, -t}, {row.face_to, -t}, std::move(corridor)));
    }
    for (std::size_t count = wing.polygons(); !shelves.empty() && count + polygons_of_shelf / 2 <= polygons;
         count += polygons_of_shelf) {
        std::swap(shelves[random.below(shelves.size())], shelves.back());
        wing.boxes.push_back(shelves.back());
        shelves.pop_back();
    }
    return wing;
}

OfficeWing outer_face(WingSide side, bool left_corner, bool right_corner) {
    const auto [at, degrees] = exits()[static_cast<std::size_t>(side)];
    // In the exit's frame the outside is behind the wall, so who stands there has the largest x on the left.
    const Placement frame = turned(at, degrees);
    const bool long_side = side == WingSide::south || side == WingSide::north;
    const double half = (long_side ? wing_size.x : wing_size.y) / 2;
    const double left = half + (left_corner ? outer : 0), right = half + (right_corner ? outer : 0);
    OfficeWing face;
    const double thick = half_outer_wall;
    face.faces.push_back(face_of(frame, {left, 2 * thick}, {-right, 2 * thick}, {{left, exit_width}}));
    add_doorway(face, doorway_of(frame, 0, exit_width, thick, 2 * thick));
    return face;
}

}  // namespace sightline
