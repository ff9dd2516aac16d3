// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/furniture.h"

namespace sightline {

namespace {

constexpr unsigned upright = left_side | right_side | front_side | back_side;

/// A post that stands on something and carries something: nobody sees its ends.
void leg(Model& m, double x, double y, double half, double z0, double z1) {
    m.box({x - half, y - half, z0}, {x + half, y + half, z1}, upright);
}

}  // namespace

void chair(Model& m) {
    for (const double x : {-0.19, 0.19})
        for (const double y : {-0.19, 0.19}) leg(m, x, y, 0.02, 0, 0.43);
    m.box({-0.22, -0.22, 0.43}, {0.22, 0.22, 0.47});
    m.box({-0.22, 0.18, 0.47}, {0.22, 0.22, 0.95}, all_sides & ~bottom_side);
}

void table(Model& m, double width, double depth) {
    for (const double x : {-width / 2 + 0.08, width / 2 - 0.08})
        for (const double y : {-depth / 2 + 0.08, depth / 2 - 0.08}) leg(m, x, y, 0.03, 0, 0.71);
    m.box({-width / 2, -depth / 2, 0.71}, {width / 2, depth / 2, 0.75});
}

void dining_table(Model& m) {
    table(m, 1.5, 0.9);
    for (const double x : {-0.38, 0.38})
        for (const double side : {-1.0, 1.0}) {
            const Inside place(m, {x, side * 0.62, 0}, side < 0 ? 180 : 0);
            chair(m);
        }
}

void shelf(Model& m, Random& random, double width, double height) {
    const double half = width / 2, thick = 0.03, depth = 0.32;
    for (const double side : {-1.0, 1.0}) {
        const double x0 = side < 0 ? -half : half - thick;
        m.box({x0, -depth, 0}, {x0 + thick, 0, height}, all_sides & ~bottom_side);
    }
    const int boards = static_cast<int>(height / 0.4);
    for (int i = 0; i <= boards; ++i) {
        const double z = i == boards ? height - thick : 0.05 + (height - 0.05) * i / boards;
        m.box({-half + thick, -depth, i == 0 ? 0 : z}, {half - thick, -0.02, z + thick},
              front_side | top_side | (i > 0 ? unsigned{bottom_side} : 0u));
        if (i == boards) break;
        // A row of books, leaving some of the board free.
        const double books = (width - 2 * thick) * random.uniform(0.3, 0.9), tall = random.uniform(0.2, 0.3);
        m.box({-half + thick, -0.24, z + thick}, {-half + thick + books, -0.02, z + thick + tall},
              front_side | top_side | right_side);
    }
    m.box({-half + thick, -0.02, 0}, {half - thick, 0, height}, front_side | back_side | top_side);
}

void bed(Model& m, double width) {
    const double half = width / 2;
    for (const double x : {-half + 0.06, half - 0.06})
        for (const double y : {-1.92, -0.12}) leg(m, x, y, 0.04, 0, 0.2);
    m.box({-half, -2, 0.2}, {half, -0.04, 0.35});
    m.box({-half + 0.02, -1.97, 0.35}, {half - 0.02, -0.06, 0.52}, all_sides & ~bottom_side);
    m.box({-half, -0.04, 0}, {half, 0, 0.9}, all_sides & ~bottom_side);
    m.box({-half + 0.15, -0.5, 0.52}, {half - 0.15, -0.1, 0.62}, all_sides & ~bottom_side);
}

void sofa(Model& m) {
    m.box({-1, -0.85, 0.05}, {1, -0.2, 0.42});
    m.box({-1, -0.2, 0}, {1, 0, 0.85}, all_sides & ~bottom_side);
    for (const double side : {-1.0, 1.0}) {
        const double x0 = side < 0 ? -1.15 : 1.0;
        m.box({x0, -0.85, 0}, {x0 + 0.15, 0, 0.6}, all_sides & ~bottom_side);
    }
    for (const double x : {-0.97, 0.02}) m.box({x, -0.83, 0.42}, {x + 0.95, -0.22, 0.52}, all_sides & ~bottom_side);
}

void desk(Model& m) {
    {
        const Inside place(m, {0, -0.35, 0});
        table(m, 1.4, 0.7);
    }
    m.box({-0.3, -0.2, 0.78}, {0.3, -0.16, 1.15});
    m.box({-0.04, -0.19, 0.75}, {0.04, -0.17, 0.78}, upright);
    m.box({0.4, -0.66, 0.1}, {0.66, -0.1, 0.68});
    const Inside place(m, {-0.1, -0.9, 0}, 180);
    chair(m);
}

void furnish_room(Model& m, Random& random, double width, double depth) {
    const double wall = depth / 2 - 0.05;  // the wall at the back, where things lean
    switch (random.below(5)) {
        case 0:
            dining_table(m);
            break;
        case 1: {
            const Inside place(m, {-width / 2 + 1.1, wall, 0});
            bed(m, 1.6);
            break;
        }
        case 2: {
            {
                const Inside place(m, {0, wall, 0});
                sofa(m);
            }
            const Inside place(m, {0, wall - 1.6, 0});
            table(m, 0.9, 0.5);
            break;
        }
        case 3: {
            const Inside place(m, {-width / 2 + 1, wall, 0});
            desk(m);
            break;
        }
        default: {
            const Inside place(m, {-width / 2 + 0.8, wall, 0});
            shelf(m, random, 1.3, 2);
            break;
        }
    }
    // Something against the wall on the right, turned to look into the room.
    const Inside place(m, {width / 2 - 0.05, random.uniform(-0.2, 0.2) * depth, 0}, -90);
    const double wide = random.uniform(0.8, 1.4), high = random.uniform(1.2, 2.1);
    if (random.below(2) == 0)
        shelf(m, random, wide, high);
    else
        m.box({-0.5, -0.45, 0}, {0.5, 0, 0.9}, all_sides & ~bottom_side);
}

void garden_tree(Model& m, Random& random) {
    const double tall = random.uniform(0.85, 1.2);
    m.turned_solid({0, 0, 0}, {0, 0, 1}, {{0.16, 0}, {0.1, 2.2 * tall}, {0.1, 2.6 * tall}}, 6);
    if (random.below(3) == 0) {  // a fir: three skirts
        for (int i = 0; i < 3; ++i) {
            const double z = (1 + 1.1 * i) * tall, r = 1.5 - 0.35 * i;
            m.turned_solid({0, 0, z}, {0, 0, 1}, {{0, 0.1}, {r, 0}, {0, 1.9 * tall}}, 9);
        }
        return;
    }
    const double r = random.uniform(1.2, 1.7), z = 2.1 * tall;
    m.turned_solid({0, 0, z}, {0, 0, 1}, {{0, 0}, {0.75 * r, 0.3 * r}, {r, r}, {0.7 * r, 1.7 * r}, {0, 2.1 * r}}, 9);
}

void street_lamp(Model& m) {
    m.turned_solid({0, 0, 0}, {0, 0, 1}, {{0.12, 0}, {0.12, 0.4}, {0.06, 0.5}, {0.05, 4.6}, {0, 4.65}}, 6);
    m.rod({0, 0.03, 4.5}, {0, -1.1, 4.7}, 0.035, 5);
    m.box({-0.12, -1.5, 4.62}, {0.12, -0.95, 4.74});
}

}  // namespace sightline
