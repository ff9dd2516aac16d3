// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/sketch.h"

#include <array>

namespace sightline {

Placement turned(const Vec<2>& origin, double degrees) {
    const SinCos turn = sincos_degrees(degrees);
    return {origin, turn.cos, turn.sin};
}

void Sketch::path(std::span<const Vec<2>> points, bool closed) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) line(points[i], points[i + 1]);
    if (closed && points.size() > 2) line(points.back(), points.front());
}

void Sketch::box(double x0, double y0, double x1, double y1) { path({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true); }

void Sketch::ring(const Vec<2>& centre, double radius, int corners, double degrees) {
    std::vector<Vec<2>> points;
    for (int i = 0; i < corners; ++i) {
        const SinCos turn = sincos_degrees(degrees + 360.0 * i / corners);
        points.push_back(centre + radius * Vec<2>(turn.cos, turn.sin));
    }
    path(points, true);
}

void Sketch::wall(const Vec<2>& a, const Vec<2>& b, std::span<const Opening> openings) {
    const Vec<2> along = (b - a) / std::sqrt(glm::dot(b - a, b - a));
    Vec<2> from = a;
    for (const Opening& gap : openings) {
        line(from, a + along * (gap.at - gap.width / 2));
        from = a + along * (gap.at + gap.width / 2);
    }
    line(from, b);
}

namespace {

/// A frame inside the sketch's own, for one piece of furniture, until the end of the scope.
class Place {
public:
    Place(Sketch& sketch, const Vec<2>& centre, double degrees) : sketch_(sketch), outer_(sketch.frame) {
        const Placement inner = turned({0, 0}, degrees);
        sketch.frame = {outer_.at(centre), outer_.cos * inner.cos - outer_.sin * inner.sin,
                        outer_.sin * inner.cos + outer_.cos * inner.sin};
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { sketch_.frame = outer_; }

private:
    Sketch& sketch_;
    Placement outer_;
};

void put_chair(Sketch& s, const Vec<2>& at, double degrees) {
    const Place place(s, at, degrees);
    s.box(-0.22, -0.22, 0.22, 0.18);
    s.line({-0.2, 0.24}, {0.2, 0.24});
}

void put_table(Sketch& s, Random& random, const Vec<2>& at, double degrees) {
    const Place place(s, at, degrees);
    if (random.below(3) == 0) {
        s.ring({0, 0}, 0.5, 10);
        for (int i = 0; i < 4; ++i) {
            const SinCos turn = sincos_degrees(90.0 * i);
            put_chair(s, {0.85 * turn.cos, 0.85 * turn.sin}, 90.0 * i - 90);
        }
        return;
    }
    s.box(-0.75, -0.42, 0.75, 0.42);
    for (const double x : {-0.38, 0.38}) {
        put_chair(s, {x, 0.75}, 0);
        put_chair(s, {x, -0.75}, 180);
    }
}

void put_bed(Sketch& s, const Vec<2>& at, double degrees) {
    const Place place(s, at, degrees);
    s.box(-0.8, -1, 0.8, 1);
    s.box(-0.65, 0.5, -0.08, 0.85);
    s.box(0.08, 0.5, 0.65, 0.85);
    s.line({-0.75, 0.3}, {0.75, 0.3});
}

void put_sofa(Sketch& s, const Vec<2>& at, double degrees) {
    const Place place(s, at, degrees);
    s.path({{-1, -0.4}, {-0.8, -0.4}, {-0.8, 0.1}, {0.8, 0.1}, {0.8, -0.4}, {1, -0.4}, {1, 0.4}, {-1, 0.4}}, true);
    s.line({0, 0.05}, {0, -0.38});
    s.box(-0.5, -1.15, 0.5, -0.7);
}

void put_desk(Sketch& s, const Vec<2>& at, double degrees) {
    const Place place(s, at, degrees);
    s.box(-0.7, 0, 0.7, 0.7);
    s.box(-0.25, 0.42, 0.25, 0.5);      // screen
    s.line({-0.2, 0.22}, {0.2, 0.22});  // keyboard
    put_chair(s, {0, -0.35}, 180);
}

void put_shelf(Sketch& s, const Vec<2>& at, double degrees, double length) {
    const Place place(s, at, degrees);
    s.box(-length / 2, -0.2, length / 2, 0.2);
    const int boards = static_cast<int>(length / 0.5);
    for (int i = 1; i < boards; ++i) {
        const double x = -length / 2 + length * i / boards;
        s.line({x, -0.15}, {x, 0.15});
    }
}

void furnish_living(Sketch& s, Random& random, const RoomPlan& room) {
    const Vec<2> centre((room.x0 + room.x1) / 2, (room.y0 + room.y1) / 2);
    const double turn = 90.0 * static_cast<double>(random.below(4));
    switch (random.below(4)) {
        case 0:
            return put_table(s, random, centre, turn);
        case 1:
            return put_bed(s, centre, turn);
        case 2:
            return put_sofa(s, centre, turn);
        default:
            return put_desk(s, centre, turn);
    }
}

void furnish_office(Sketch& s, Random& random, const RoomPlan& room) {
    if (random.below(4) == 0) {  // a meeting room
        const Vec<2> centre((room.x0 + room.x1) / 2, (room.y0 + room.y1) / 2);
        const double half = room.depth() / 2 - 2;
        s.ring(centre, 0.2, 6);
        s.path({{centre.x - 0.8, centre.y - half},
                {centre.x + 0.8, centre.y - half},
                {centre.x + 1, centre.y},
                {centre.x + 0.8, centre.y + half},
                {centre.x - 0.8, centre.y + half},
                {centre.x - 1, centre.y}},
               true);
        for (double y = centre.y - half + 0.5; y < centre.y + half; y += 0.9) {
            put_chair(s, {centre.x - 1.3, y}, 90);
            put_chair(s, {centre.x + 1.3, y}, -90);
        }
        return;
    }
    const double margin = 1.1;
    const int columns = static_cast<int>((room.width() - margin) / 2.6);
    const int rows = static_cast<int>((room.depth() - margin) / 2.6);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (random.below(6) == 0) continue;
            const double x = room.x0 + room.width() * (column + 0.5) / columns;
            const double y = room.y0 + room.depth() * (row + 0.5) / rows;
            put_desk(s, {x, y - 0.2}, row % 2 == 0 ? 0 : 180);
        }
}

void furnish_storage(Sketch& s, const RoomPlan& room) {
    const int rows = static_cast<int>((room.depth() - 1) / 1.8);
    for (int row = 0; row < rows; ++row)
        put_shelf(s, {(room.x0 + room.x1) / 2, room.y0 + room.depth() * (row + 0.5) / rows}, 0, room.width() - 1.8);
}

}  // namespace

void furnish(Sketch& sketch, Random& random, const RoomPlan& room, Furnishing furnishing) {
    if (room.width() < 2.9 || room.depth() < 2.9) return;
    switch (furnishing) {
        case Furnishing::living:
            return furnish_living(sketch, random, room);
        case Furnishing::office:
            return furnish_office(sketch, random, room);
        case Furnishing::storage:
            return furnish_storage(sketch, room);
    }
}

void tree(Sketch& sketch, Random& random, const Vec<2>& centre, double radius) {
    const Place place(sketch, centre, random.uniform(0, 360));
    sketch.ring({0, 0}, radius * 0.25, 6);
    std::vector<Vec<2>> crown;
    for (int i = 0; i < 14; ++i) {
        const SinCos turn = sincos_degrees(360.0 * i / 14);
        crown.push_back(radius * (i % 2 == 0 ? 1.0 : random.uniform(0.7, 0.85)) * Vec<2>(turn.cos, turn.sin));
    }
    sketch.path(crown, true);
}

void crate(Sketch& sketch, Random& random, const Vec<2>& centre, double side) {
    const Place place(sketch, centre, random.uniform(-20, 20));
    const double h = side / 2, inner = side * 0.38;
    sketch.box(-h, -h * random.uniform(0.7, 1.0), h, h);
    sketch.line({-inner, -inner * 0.6}, {inner, inner});
}

namespace {

/// The middle and half the width of a gap, so that no wall ends in it.
struct Gap {
    Vec<2> at;
    double half;
};

struct HousePlan {
    Sketch& sketch;
    Random& random;
    const HouseStyle& style;
    std::vector<Gap> gaps;

    bool in_gap(const Vec<2>& p) const {
        for (const Gap& gap : gaps)
            if ((p.x == gap.at.x && std::abs(p.y - gap.at.y) < gap.half + 0.1) ||
                (p.y == gap.at.y && std::abs(p.x - gap.at.x) < gap.half + 0.1))
                return true;
        return false;
    }
    /// An outer wall along the local x axis (y fixed) or y axis with windows and perhaps a door in the middle.
    void outer(const Vec<2>& a, const Vec<2>& b, bool door, int windows) {
        const double length = std::abs(b.x - a.x) + std::abs(b.y - a.y);
        std::vector<Opening> openings;
        if (style.openings) {
            const int slots = windows + (door ? 1 : 0);
            const int door_slot = door ? static_cast<int>(random.below(static_cast<std::uint64_t>(slots))) : -1;
            for (int i = 0; i < slots; ++i) {
                const double at = length * (i + 0.5) / slots + random.uniform(-0.2, 0.2);
                openings.push_back({at, i == door_slot ? 1.0 : 0.8});
                const Vec<2> middle = a + (b - a) * (at / length);
                gaps.push_back({{a.x == b.x ? a.x : middle.x, a.y == b.y ? a.y : middle.y}, 0.5});
                // The door stands open, into the house.
                if (i == door_slot)
                    sketch.line({middle.x - 0.5, a.y}, {middle.x - 0.5 + 0.3, a.y + (a.y == 0 ? 0.9 : -0.9)});
            }
        }
        sketch.wall(a, b, openings);
    }
    void divide(const RoomPlan& room, int depth) {
        const bool wide = room.width() > room.depth();
        if (depth == 0 || std::max(room.width(), room.depth()) < 2 * style.smallest_room) return finish(room);
        for (int attempt = 0; attempt < 24; ++attempt) {
            const bool across = attempt < 16 ? wide : !wide;  // the new wall runs along y
            const double size = across ? room.width() : room.depth();
            if (size < 1.6 * style.smallest_room) return finish(room);
            const double share = random.uniform(0.36, 0.64);
            const double at = (across ? room.x0 : room.y0) + share * size;
            const Vec<2> a = across ? Vec<2>(at, room.y0) : Vec<2>(room.x0, at);
            const Vec<2> b = across ? Vec<2>(at, room.y1) : Vec<2>(room.x1, at);
            if (in_gap(a) || in_gap(b)) continue;
            const double length = across ? room.depth() : room.width();
            const double door = random.uniform(0.8, length - 0.8);
            const Opening opening{door, 0.9};
            sketch.wall(a, b, std::span(&opening, 1));
            gaps.push_back({across ? Vec<2>(at, a.y + door) : Vec<2>(a.x + door, at), 0.45});
            RoomPlan first = room, second = room;
            (across ? first.x1 : first.y1) = at;
            (across ? second.x0 : second.y0) = at;
            divide(first, depth - 1);
            divide(second, depth - 1);
            return;
        }
        finish(room);
    }
    void finish(const RoomPlan& room) {
        if (style.furniture) furnish(sketch, random, room, Furnishing::living);
    }
};

}  // namespace

void house(Sketch& sketch, Random& random, double width, double depth, const HouseStyle& style) {
    HousePlan plan{sketch, random, style, {}};
    const int windows = static_cast<int>(width / 3.5);
    plan.outer({0, 0}, {width, 0}, true, windows);
    plan.outer({width, 0}, {width, depth}, false, 0);
    plan.outer({0, depth}, {width, depth}, random.below(2) == 0, windows - 1 > 0 ? windows - 1 : 1);
    plan.outer({0, 0}, {0, depth}, false, 0);
    plan.divide({0, 0, width, depth}, 4);
}

}  // namespace sightline
