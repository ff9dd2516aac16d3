// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/campus_things.h"

#include "core/scene/make/furniture.h"

namespace sightline {

namespace {

constexpr unsigned no_back = all_sides & ~back_side, standing = all_sides & ~bottom_side;
constexpr double free_half = 0.65;

void plain_chair(Model& m) {
    m.box({-0.22, -0.22, 0.3}, {0.22, 0.22, 0.45});
    m.box({-0.22, 0.18, 0.45}, {0.22, 0.22, 0.9}, standing);
}

/// Furnishes a room in its own frame: the middle of the floor is the origin and the corridor is at smaller y.
class Furnisher {
public:
    Furnisher(NamedModel& made, NumberedNames& names, Random& random, double width, double depth, double door)
        : made_(made), names_(names), random_(random), width_(width), depth_(depth), door_(door) {}

    /// An open leaf, radiators and lamps.
    void basics() {
        {
            const Inside hinge(made_.model, {door_ - 0.4375, -depth_ / 2 + 0.03, 0}, random_.uniform(86, 100));
            thing("door", [](Model& m) { m.box({0.02, 0, 0.01}, {0.84, 0.04, 2.06}); });
        }
        for (const double share : {-0.23, 0.23}) {
            const double x = share * width_;
            thing("radiator", [&](Model& m) {
                m.box({x - 0.55, depth_ / 2 - 0.16, 0.12}, {x + 0.55, depth_ / 2 - 0.05, 0.72});
            });
            thing("lamp", [&](Model& m) {
                m.box({x - 0.6, -0.1, campus_storey - 0.14}, {x + 0.6, 0.1, campus_storey - 0.05});
            });
            if (random_.below(2) == 0) pot(x + 0.2, depth_ / 2 - 0.1, 0.75);
        }
        if (random_.below(2) == 0) pot(corner_x(1), -depth_ / 2 + 0.4, 0);
        const double x = corner_x(random_.below(2) == 0 ? -1 : 1);
        thing("bin", [&](Model& m) {
            m.turned_solid({x, depth_ / 2 - 0.5, 0}, {0, 0, 1}, {{0.12, 0}, {0.16, 0.4}, {0, 0.38}}, 7);
        });
    }

    void office() {
        for (const int side : {-1, 1}) {
            if (zone(side) < 1.2) continue;
            const Inside wall = along_wall(side);
            const double at = side < 0 ? 1.1 : -1.1, near = side < 0 ? -0.35 : 0.35;
            if (side > 0 && random_.below(3) == 0) {
                for (const double x : {-1.65, -0.6}) {
                    const Inside place(made_.model, {x, 0, 0});
                    const double high = random_.uniform(1.6, 2.1);
                    thing("shelf", [&](Model& m) { shelf(m, random_, 1, high); });
                }
            } else {
                workplace(at);
            }
            cupboard(near);
            picture(at);
        }
    }

    void seminar() {
        for (const int side : {-1, 1}) {
            const Inside wall = along_wall(side);
            for (const double at : {-0.1, 1.5}) {
                const double x = side < 0 ? at : -at;
                thing("table", [&](Model& m) {
                    const Inside place(m, {x, -0.45, 0});
                    table(m, 1.3, 0.6);
                });
                if (zone(side) > 1.4)
                    for (const double aside : {-0.33, 0.33}) {
                        const Inside place(made_.model, {x + aside, -1.05, 0}, 180);
                        thing("chair", plain_chair);
                    }
                thing("book", [&](Model& m) { m.box({x - 0.3, -0.6, 0.75}, {x - 0.05, -0.25, 0.78}, standing); });
                picture(x);
            }
        }
        thing("board", [&](Model& m) {
            m.box({door_ + 0.6, -depth_ / 2 + 0.01, 1}, {width_ / 2 - 0.2, -depth_ / 2 + 0.05, 2.1});
        });
    }

    void laboratory() {
        for (const int side : {-1, 1}) {
            const Inside wall = along_wall(side);
            const double way = side < 0 ? 1 : -1;
            thing("bench", [&](Model& m) {
                const Inside place(m, {0.7 * way, -0.4, 0});
                table(m, 3, 0.7);
            });
            for (int i = 0; i < 6; ++i) {
                const double x = way * (-0.6 + 0.5 * i), wide = random_.uniform(0.12, 0.22);
                const double deep = random_.uniform(0.15, 0.28), high = random_.uniform(0.1, 0.6);
                thing("device", [&](Model& m) {
                    m.box({x - wide, -0.35 - deep, 0.75}, {x + wide, -0.1, 0.75 + high}, standing);
                });
            }
            for (const double at : {0.0, 1.3})
                thing("stool", [&](Model& m) {
                    m.turned_solid({way * at, -1, 0}, {0, 0, 1},
                                   {{0.18, 0}, {0.04, 0.05}, {0.04, 0.5}, {0.17, 0.52}, {0, 0.56}}, 6);
                });
            for (const double at : {-0.3, 0.6, 1.5})
                thing("wall cupboard", [&](Model& m) {
                    m.box({way * at - 0.4, -0.35, 1.5}, {way * at + 0.4, -0.02, 2.2});
                });
        }
    }

    /// Rows of seats on both sides of the way from door to door.
    void hall() {
        for (double y = -depth_ / 2 + 3.5; y + 1 < depth_ / 2 - 1.2; y += 1.2)
            for (const int side : {-1, 1})
                for (int i = 0; i < 3; ++i) {
                    const double piece = (width_ / 2 - 2) / 3, x0 = 1 + piece * i, x1 = x0 + piece - 0.25;
                    const double low = side < 0 ? -x1 : x0, high = side < 0 ? -x0 : x1;
                    thing("row", [&](Model& m) {
                        m.box({low, y, 0}, {high, y + 0.05, 0.75}, standing);
                        m.box({low, y - 0.3, 0.75}, {high, y + 0.05, 0.79});
                    });
                    thing("seat", [&](Model& m) {
                        m.box({low, y + 0.35, 0.4}, {high, y + 0.75, 0.45});
                        m.box({low, y + 0.75, 0.1}, {high, y + 0.8, 0.9});
                    });
                }
        for (double x = -width_ / 2 + 2; x < width_ / 2; x += 4)
            for (double y = -depth_ / 2 + 2; y < depth_ / 2; y += 4)
                thing("lamp", [&](Model& m) {
                    m.box({x - 0.6, y - 0.1, campus_storey - 0.14}, {x + 0.6, y + 0.1, campus_storey - 0.05});
                });
        thing("lectern", [&](Model& m) {
            m.box({1.6, -depth_ / 2 + 1.4, 0}, {2.3, -depth_ / 2 + 1.9, 1.15}, standing);
        });
    }

    void corridor() {
        for (double x = -width_ / 2 + 2; x < width_ / 2 - 1; x += 4) {
            thing("lamp", [&](Model& m) {
                m.box({x - 0.6, -0.1, campus_storey - 0.14}, {x + 0.6, 0.1, campus_storey - 0.05});
            });
            thing("sign", [&](Model& m) {
                m.box({x - 0.05, -0.6, campus_storey - 0.5}, {x, 0.6, campus_storey - 0.2});
            });
        }
    }

    void kiosk() {
        for (const int side : {-1, 1}) {
            const double x = side * (width_ / 2 - 1.2);
            thing("counter", [&](Model& m) {
                m.box({x - 0.3, -depth_ / 2 + 1.2, 0}, {x + 0.3, depth_ / 2 - 1.2, 1}, standing);
            });
            const Inside wall = along_wall(side);
            for (const double at : {-1.1, 0.0, 1.1}) {
                const Inside place(made_.model, {at, 0, 0});
                thing("shelf", [&](Model& m) { shelf(m, random_, 1, 2); });
            }
        }
    }

private:
    template <typename Build>
    void thing(const char* kind, Build build) {
        made_.add(names_.next(kind), build);
    }
    /// How far the side reaches from its wall to the way that stays free.
    double zone(int side) const { return width_ / 2 + side * door_ * -1 - free_half; }
    double corner_x(int side) const { return side * (width_ / 2 - 0.3); }
    /// x along the wall, the room at y < 0.
    Inside along_wall(int side) { return {made_.model, {side * (width_ / 2 - 0.02), 0.2, 0}, side < 0 ? 90.0 : -90.0}; }

    void pot(double x, double y, double z) {
        thing("plant", [&](Model& m) {
            m.turned_solid({x, y, z}, {0, 0, 1}, {{0.05, 0}, {0.08, 0.12}, {0, 0.12}}, 5);
            m.turned_solid({x, y, z + 0.12}, {0, 0, 1}, {{0, 0}, {0.09, 0.15}, {0, 0.4}}, 5);
        });
    }
    /// At x of a wall's frame; the chair looks at the wall.
    void workplace(double x) {
        thing("desk", [&](Model& m) {
            const Inside place(m, {x, -0.37, 0});
            table(m, 1.4, 0.7);
        });
        thing("screen", [&](Model& m) {
            m.box({x - 0.28, -0.2, 0.8}, {x + 0.28, -0.16, 1.15});
            m.box({x - 0.04, -0.19, 0.75}, {x + 0.04, -0.17, 0.8}, left_side | right_side | front_side | back_side);
        });
        thing("keyboard", [&](Model& m) { m.box({x - 0.22, -0.6, 0.75}, {x + 0.22, -0.45, 0.77}, standing); });
        for (const double at : {-0.6, 0.3})
            thing("book", [&](Model& m) { m.box({x + at, -0.5, 0.75}, {x + at + 0.25, -0.25, 0.79}, standing); });
        thing("drawers", [&](Model& m) { m.box({x + 0.25, -0.65, 0.05}, {x + 0.6, -0.1, 0.65}); });
        const double turn = random_.uniform(165, 195);
        const Inside place(made_.model, {x - 0.1, -1, 0}, turn);
        thing("chair", plain_chair);
    }
    void cupboard(double x) {
        const double high = random_.uniform(0.8, 1.9);
        thing("cupboard", [&](Model& m) { m.box({x - 0.4, -0.42, 0}, {x + 0.4, -0.01, high}, standing); });
        thing("file", [&](Model& m) { m.box({x - 0.3, -0.35, high}, {x - 0.1, -0.05, high + 0.3}, standing); });
        thing("file", [&](Model& m) { m.box({x - 0.05, -0.35, high}, {x + 0.2, -0.05, high + 0.22}, standing); });
    }
    void picture(double x) {
        const double half = random_.uniform(0.2, 0.4);
        thing("picture", [&](Model& m) { m.box({x - half, -0.02, 1.4}, {x + half, 0, 1.95}, no_back); });
    }

    NamedModel& made_;
    NumberedNames& names_;
    Random& random_;
    double width_, depth_, door_;
};

}  // namespace

void furnish_planned(NamedModel& made, NumberedNames& names, Random random, const PlannedRoom& room) {
    const RoomPlan& r = room.floor;
    const double turn = room.back ? 0 : 180, middle = (r.x0 + r.x1) / 2;
    const double door = room.use == PlannedUse::corridor ? 0 : room.back ? room.door - middle : middle - room.door;
    const Inside frame(made.model, {middle, (r.y0 + r.y1) / 2, 0}, turn);
    Furnisher furnisher(made, names, random, r.width(), r.depth(), door);
    switch (room.use) {
        case PlannedUse::corridor:
            furnisher.corridor();
            return;
        case PlannedUse::hall:
            furnisher.hall();
            return;
        case PlannedUse::kiosk:
            furnisher.kiosk();
            return;
        case PlannedUse::office:
            furnisher.basics();
            furnisher.office();
            return;
        case PlannedUse::seminar:
            furnisher.basics();
            furnisher.seminar();
            return;
        case PlannedUse::laboratory:
            furnisher.basics();
            furnisher.laboratory();
    }
}

void simple_car(Model& m) {
    for (const double x : {-1.3, 1.2})
        for (const double side : {-1.0, 1.0})
            m.turned_solid({x, side * 0.62, 0.3}, {0, side, 0}, {{0.3, 0}, {0.3, 0.2}, {0, 0.22}}, 8);
    m.box({-2.1, -0.8, 0.25}, {2.1, 0.8, 0.8});
    // The cabin is narrower above.
    const Vec<3> low[] = {{-0.9, -0.75, 0.8}, {1.9, -0.75, 0.8}, {1.9, 0.75, 0.8}, {-0.9, 0.75, 0.8}};
    const Vec<3> high[] = {{-0.2, -0.6, 1.4}, {1.5, -0.6, 1.4}, {1.5, 0.6, 1.4}, {-0.2, 0.6, 1.4}};
    for (std::size_t i = 0; i < 4; ++i) m.polygon({low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]});
    m.polygon({high[0], high[1], high[2], high[3]});
    for (const double x : {-2.15, 2.05}) m.box({x, -0.75, 0.3}, {x + 0.1, 0.75, 0.5});  // bumpers
}

void bench(Model& m) {
    m.box({-0.9, -0.2, 0.4}, {0.9, 0.2, 0.45});
    m.box({-0.9, 0.2, 0.35}, {0.9, 0.25, 0.85});
    for (const double x : {-0.8, 0.7})
        m.box({x, -0.18, 0}, {x + 0.1, 0.22, 0.4}, left_side | right_side | front_side | back_side);
}

void bollard(Model& m) { m.turned_solid({0, 0, 0}, {0, 0, 1}, {{0.1, 0}, {0.1, 0.8}, {0.06, 0.9}, {0, 0.9}}, 7); }

}  // namespace sightline
