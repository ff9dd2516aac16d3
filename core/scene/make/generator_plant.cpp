// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/scene/make/generators_3d.h"
#include "core/scene/make/model.h"
#include "core/scene/make/plots.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

// A bay of steel frames stands in the middle of its plot; what is left on all sides is half a lane.
constexpr double hall_side = 9, lane = 2.4, bay = hall_side - lane, level = 3.4;
constexpr unsigned side_faces = left_side | right_side | front_side | back_side;

/// A post of H section, its length from z0 to z1.
void post(Model& m, double x, double y, double z0, double z1) {
    m.box({x - 0.12, y - 0.14, z0}, {x + 0.12, y - 0.11, z1}, side_faces);
    m.box({x - 0.12, y + 0.11, z0}, {x + 0.12, y + 0.14, z1}, side_faces);
    m.box({x - 0.015, y - 0.11, z0}, {x + 0.015, y + 0.11, z1}, left_side | right_side);
}

/// A railing along x on the local floor.
void railing(Model& m, double length) {
    for (const double z : {0.5, 1.0}) m.rod({0, 0, z}, {length, 0, z}, 0.02, 4);
    for (int i = 0; i <= 4; ++i) {
        const double x = length * i / 4;
        m.box({x - 0.02, -0.02, 0}, {x + 0.02, 0.02, 1.02}, side_faces | top_side);
    }
}

void frame_of_bay(Model& m, int levels) {
    const double top = level * levels;
    for (const double x : {0.15, bay - 0.15})
        for (const double y : {0.15, bay - 0.15}) post(m, x, y, 0, top);
    for (int i = 1; i <= levels; ++i) {
        const double z = level * i;
        for (const double at : {0.15, bay - 0.15}) {
            m.box({0, at - 0.08, z - 0.25}, {bay, at + 0.08, z});
            m.box({at - 0.08, 0.23, z - 0.25}, {at + 0.08, bay - 0.23, z},
                  left_side | right_side | bottom_side | top_side);
        }
    }
}

/// A walkway round the inside of the frame, 1 m wide, with railings.
void walkway(Model& m, int storey) {
    const Inside floor(m, {0, 0, level * storey});
    for (int side = 0; side < 4; ++side) {
        const std::array<Vec<3>, 4> corner = {{{0, 0, 0}, {bay, 0, 0}, {bay, bay, 0}, {0, bay, 0}}};
        const Inside place(m, corner[static_cast<std::size_t>(side)], 90.0 * side);
        m.box({0, 0, 0}, {bay - 1, 1, 0.05});
        const Inside edge(m, {0, 0.05, 0.05});
        railing(m, bay - 0.1);
    }
}

void stairs(Model& m) {
    constexpr int steps = 14;
    for (int i = 0; i < steps; ++i) {
        const double x = 0.25 * i, z = level * (i + 1) / steps;
        m.box({x, 0, z - 0.04}, {x + 0.28, 0.8, z});
    }
    for (const double y : {-0.03, 0.83}) m.rod({0, y, 0.9}, {0.25 * steps, y, level + 0.9}, 0.02, 5);
}

void ladder(Model& m, double height) {
    for (const double x : {-0.22, 0.22}) m.box({x - 0.02, -0.02, 0}, {x + 0.02, 0.02, height}, side_faces | top_side);
    for (double z = 0.3; z < height; z += 0.4)
        m.box({-0.2, -0.015, z}, {0.2, 0.015, z + 0.03}, front_side | back_side | top_side | bottom_side);
}

void tank(Model& m, Random& random) {
    const double r = random.uniform(1.5, 2.1), h = random.uniform(3.6, 6.2);
    m.turned_solid({0, 0, 0}, {0, 0, 1},
                   {{r + .1, 0},
                    {r + .1, .15},
                    {r, .15},
                    {r, h * .45},
                    {r + .04, h * .45 + .04},
                    {r, h * .45 + .08},
                    {r, h},
                    {.87 * r, h + .22 * r},
                    {.5 * r, h + .4 * r},
                    {0, h + .46 * r}},
                   20);
    m.turned_solid({0, 0, h + 0.4 * r}, {0, 0, 1}, {{0.2, 0}, {0.2, 0.5}, {0.28, 0.5}, {0.28, 0.56}, {0, 0.56}}, 10);
    const Inside place(m, {0, -r - 0.2, 0});
    ladder(m, h + 0.2);
}

/// A vessel lying along x on two saddles.
void vessel(Model& m, double z, double r, double half) {
    m.turned_solid({-half, 0, z}, {1, 0, 0},
                   {{0, -.3 * r},
                    {.6 * r, -.2 * r},
                    {r, .1},
                    {r, .3},
                    {r + .07, .3},
                    {r + .07, .38},
                    {r, .38},
                    {r, 2 * half - .38},
                    {r + .07, 2 * half - .38},
                    {r + .07, 2 * half - .3},
                    {r, 2 * half - .3},
                    {r, 2 * half - .1},
                    {.6 * r, 2 * half + .2 * r},
                    {0, 2 * half + .3 * r}},
                   14);
    for (const double x : {-0.6 * half, 0.6 * half})
        m.box({x - 0.12, -0.7 * r, 0}, {x + 0.12, 0.7 * r, z - 0.6 * r}, side_faces);
    m.turned_solid({0, 0, z + 0.9 * r}, {0, 0, 1}, {{0.12, 0}, {0.12, 0.25}, {0.2, 0.25}, {0.2, 0.3}, {0, 0.3}}, 8);
}

/// Tubes side by side between two drums, as in a boiler.
void boiler(Model& m, Random& random) {
    const double half = bay / 2 - 1.3, top = random.uniform(4.4, 5.8);
    for (const double z : {0.8, top})
        m.turned_solid({-half - 0.2, 0, z}, {1, 0, 0},
                       {{0, 0}, {.3, .05}, {.45, .2}, {.45, 2 * half + .2}, {.3, 2 * half + .35}, {0, 2 * half + .4}},
                       14);
    for (const double x : {-half, half}) m.box({x - 0.1, -0.3, 0}, {x + 0.1, 0.3, 0.5}, side_faces);
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < 16 && !m.full(); ++i) {
            const double x = -half + 0.1 + (2 * half - 0.2) * i / 15;
            m.bent_rod({x, side * 0.3, top}, {x, side * 1.5, top - 0.6}, {x, side * 1.3, top / 2}, 0.05, 3, 6);
            m.bent_rod({x, side * 1.3, top / 2}, {x, side * 1.1, 1.2}, {x, side * 0.3, 0.8}, 0.05, 3, 6);
        }
}

void pump(Model& m, double turn) {
    const Inside place(m, {0, 0, 0}, turn);
    m.box({-0.7, -0.3, 0}, {0.7, 0.3, 0.15}, all_sides & ~bottom_side);
    m.turned_solid({-0.6, 0, 0.45}, {1, 0, 0}, {{0, 0}, {.26, .02}, {.26, .6}, {.1, .65}, {.1, .8}, {0, .8}}, 12);
    m.turned_solid({0.15, 0, 0.45}, {1, 0, 0}, {{0, 0}, {.32, 0}, {.36, .12}, {.32, .24}, {0, .24}}, 14);
    m.bent_rod({0.28, 0, 0.7}, {0.28, 0, 1.4}, {0.28, 0.8, 1.4}, 0.07, 5, 8);
    m.turned_solid({0.28, 0.78, 1.4}, {0, 1, 0}, {{0, 0}, {0.12, 0}, {0.12, 0.05}, {0, 0.05}}, 8);
}

/// A pipe with a flange that comes up, runs along x and goes down again.
void pipe(Model& m, Random& random, double y, double z, double r) {
    const int corners = 7;
    const double x0 = random.uniform(0.5, 1.6), x1 = bay - random.uniform(0.5, 1.6), bend = 4 * r;
    const double foot0 = random.uniform(0, 0.4 * z), foot1 = random.uniform(0, 0.4 * z);
    // Straight pieces are open where bends continue them.
    m.turned_solid({x0, y, foot0}, {0, 0, 1}, {{0, 0}, {r, 0}, {r, z - bend - foot0}}, corners);
    m.bent_rod({x0, y, z - bend}, {x0, y, z}, {x0 + bend, y, z}, r, 3, corners);
    m.turned_solid({x0 + bend, y, z}, {1, 0, 0}, {{r, 0}, {r, x1 - x0 - 2 * bend}}, corners);
    m.bent_rod({x1 - bend, y, z}, {x1, y, z}, {x1, y, z - bend}, r, 3, corners);
    m.turned_solid({x1, y, foot1}, {0, 0, 1}, {{0, 0}, {r, 0}, {r, z - bend - foot1}}, corners);
    const double flange = random.uniform(x0 + bend, x1 - bend - 0.1);
    m.turned_solid({flange, y, z}, {1, 0, 0}, {{0, 0}, {1.6 * r, 0}, {1.6 * r, 0.06}, {0, 0.06}}, corners);
    if (random.below(3) == 0) {  // a valve with its wheel
        m.rod({flange + 0.03, y, z + r}, {flange + 0.03, y, z + r + 0.25}, 0.02, 4);
        m.turned_solid({flange + 0.03, y, z + r + 0.22}, {0, 0, 1},
                       {{0.09, 0}, {0.13, 0}, {0.13, 0.03}, {0.09, 0.03}, {0.09, 0}}, 8);
    }
}

void pipes(Model& m, Random& random, int count, double low) {
    for (int i = 0; i < count && !m.full(); ++i) {
        const double z = low + 0.45 * static_cast<double>(random.below(6)), r = random.uniform(0.05, 0.13);
        const double y = 1.2 + (bay - 2.4) * (i + 0.5) / count;
        pipe(m, random, y, z, r);
    }
}

void add_bay(Model& m, std::uint64_t seed, const Plot& plot) {
    Random random = plot.random(seed);
    const Inside frame(m, {hall_side * plot.x, hall_side * plot.y, 0});
    m.box({0, 0, -0.1}, {hall_side, hall_side, 0}, top_side);
    const Inside place(m, {lane / 2, lane / 2, 0});
    const int levels = 2 + static_cast<int>(random.below(2));
    frame_of_bay(m, levels);
    const double turn = 90.0 * static_cast<double>(random.below(4));
    const std::uint64_t kind = random.below(5);
    {
        const Inside middle(m, {bay / 2, bay / 2, 0}, turn);
        if (m.full()) return;
        if (kind == 0) tank(m, random);
        if (kind == 1) boiler(m, random);
        if (kind == 2)
            for (const double side : {-1.1, 1.1})
                for (const double z : {1.1, 3.0}) {
                    const Inside row(m, {0, side, 0});
                    vessel(m, z, 0.65, bay / 2 - 1.4);
                    if (m.full()) return;
                }
        if (kind == 3)
            for (const double x : {-1.6, 0.0, 1.6})
                for (const double y : {-1.2, 1.2}) {
                    const Inside at(m, {x, y, 0});
                    pump(m, random.below(2) == 0 ? 90 : 270);
                    if (m.full()) return;
                }
        if (kind == 4) {
            const Inside corner(m, {-bay / 2, -bay / 2, 0});
            pipes(m, random, 10, 0.8);
        }
    }
    if (m.full()) return;
    walkway(m, 1);
    if (random.below(2) == 0 && !m.full()) {
        const Inside at(m, {1.6, 0.1, 0});
        stairs(m);
    }
    {
        // Pipes overhead, across one another on two heights.
        const bool across = random.below(2) == 0;
        const Inside turned_bay(m, across ? Vec<3>(bay, 0, 0) : Vec<3>(0, 0, 0), across ? 90 : 0);
        pipes(m, random, kind == 4 ? 3 : 6, level + 0.6);
    }
    if (levels == 3 && !m.full()) walkway(m, 2);
}

}  // namespace

Generated plant(std::uint64_t seed, std::size_t triangles) {
    Model model;
    model.wanted = triangles;
    model.triangles.reserve(triangles + 500);
    std::size_t bays = 0;
    for (const Plot& plot : plots_by_distance(triangles / 1000 + 8)) {
        if (model.full()) break;
        add_bay(model, seed, plot);
        ++bays;
    }

    Generated made;
    made.triangles = std::move(model.triangles);
    // Along the lanes round some bays when there are enough, else along one.
    const double x = 2 * hall_side, y = 2 * hall_side, z = 1.7;
    const std::vector<Vec<3>> loop = {{4, 0, z}, {-x, 0, z}, {-x, y, z}, {x, y, z}, {x, 0, z}, {4, 0, z}};
    const std::vector<Vec<3>> there = {{7, 0, z}, {-7, 0, z}};
    made.paths.push_back(along("round", bays >= 60 ? loop : there, 200, 5, 60));
    made.paths.push_back(along("tour", bays >= 60 ? loop : there, 500, 5, 60));  // as many frames as the gem's
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace sightline::generate
