// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/building.h"

#include "core/scene/make/furniture.h"

namespace sightline {

namespace {

constexpr double wall_thickness = 0.25;
constexpr double slab = 0.2;  ///< thickness of floors

void upright_rectangle(Model& m, double x0, double x1, double z0, double z1, double y, bool to_front) {
    if (!(x1 > x0 && z1 > z0)) return;
    if (to_front)
        m.polygon({{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}});
    else
        m.polygon({{x1, y, z0}, {x0, y, z0}, {x0, y, z1}, {x1, y, z1}});
}

void wall_face(Model& m, double x0, double x1, double z0, double z1, double y, bool to_front,
               std::span<const WallOpening> openings) {
    for (const WallOpening& o : openings) {
        upright_rectangle(m, x0, o.x0, z0, z1, y, to_front);
        upright_rectangle(m, o.x0, o.x1, z0, o.z0, y, to_front);
        upright_rectangle(m, o.x0, o.x1, o.z1, z1, y, to_front);
        x0 = o.x1;
    }
    upright_rectangle(m, x0, x1, z0, z1, y, to_front);
}

/// One of the four outer walls of a storey, in the frame of its left end seen from outside.
void outer_wall(Model& m, double length, double z, int windows, int door) {
    std::vector<WallOpening> openings;
    for (int i = 0; i < windows; ++i) {
        const double middle = length * (i + 0.5) / windows;
        openings.push_back(i == door ? WallOpening{middle - 0.5, middle + 0.5, z + slab, z + slab + 2.1}
                                     : WallOpening{middle - 0.55, middle + 0.55, z + slab + 0.85, z + slab + 2.1});
    }
    wall_panel(m, {0, length, z, z + storey_height, wall_thickness, wall_thickness, slab}, openings);
    for (int i = 0; i < windows; ++i) {  // bars in the windows
        const double middle = length * (i + 0.5) / windows;
        if (i != door)
            m.box({middle - 0.03, 0.1, z + slab + 0.85}, {middle + 0.03, 0.16, z + slab + 2.1},
                  left_side | right_side | front_side | back_side);
    }
}

void gable_roof(Model& m, double x0, double x1, double y0, double y1, double z, double rise) {
    const double ridge = (y0 + y1) / 2, top = z + rise;
    m.polygon({{x0, y0, z}, {x1, y0, z}, {x1, ridge, top}, {x0, ridge, top}});
    m.polygon({{x1, y1, z}, {x0, y1, z}, {x0, ridge, top}, {x1, ridge, top}});
    m.triangle({x0, y1, z}, {x0, y0, z}, {x0, ridge, top});
    m.triangle({x1, y0, z}, {x1, y1, z}, {x1, ridge, top});
    m.polygon({{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}});
}

}  // namespace

void wall_panel(Model& m, const WallPanel& wall, std::span<const WallOpening> openings) {
    wall_face(m, wall.x0, wall.x1, wall.z0, wall.z1, 0, true, openings);
    wall_face(m, wall.x0 + wall.inner_ends, wall.x1 - wall.inner_ends, wall.z0 + wall.inner_foot, wall.z1, wall.thick,
              false, openings);
    for (const WallOpening& o : openings) {
        // The cheeks look into the opening.
        m.polygon({{o.x0, 0, o.z0}, {o.x0, wall.thick, o.z0}, {o.x0, wall.thick, o.z1}, {o.x0, 0, o.z1}});
        m.polygon({{o.x1, 0, o.z0}, {o.x1, 0, o.z1}, {o.x1, wall.thick, o.z1}, {o.x1, wall.thick, o.z0}});
        m.polygon({{o.x0, 0, o.z1}, {o.x0, wall.thick, o.z1}, {o.x1, wall.thick, o.z1}, {o.x1, 0, o.z1}});
        if (o.z0 > wall.z0)
            m.polygon({{o.x0, 0, o.z0}, {o.x1, 0, o.z0}, {o.x1, wall.thick, o.z0}, {o.x0, wall.thick, o.z0}});
    }
}

void house_shell(Model& m, Random& random, const House& house) {
    const double w = house.width, d = house.depth;
    const int door = static_cast<int>(random.below(4));
    for (int storey = 0; storey < house.storeys; ++storey) {
        const double z = storey * storey_height;
        outer_wall(m, w, z, 4, storey == 0 ? door : -1);
        {
            const Inside right(m, {w, 0, 0}, 90);
            outer_wall(m, d, z, random.below(3) == 0 ? 0 : 2, -1);
        }
        {
            const Inside back(m, {w, d, 0}, 180);
            outer_wall(m, w, z, 2, storey == 0 ? static_cast<int>(random.below(2)) : -1);
        }
        {
            const Inside left(m, {0, d, 0}, 270);
            outer_wall(m, d, z, random.below(3) == 0 ? 0 : 2, -1);
        }
        m.box({wall_thickness, wall_thickness, z}, {w - wall_thickness, d - wall_thickness, z + slab},
              top_side | (storey > 0 ? unsigned{bottom_side} : 0u));
    }
    const double top = house.storeys * storey_height;
    const double x = w * (door + 0.5) / 4;
    m.box({x - 0.6, -0.5, 0}, {x + 0.6, 0, 0.1}, all_sides & ~(bottom_side | back_side));  // a step
    if (house.flat_roof) {
        m.box({-0.15, -0.15, top}, {w + 0.15, d + 0.15, top + 0.3});
        m.box({0.6 * w, 0.3 * d, top + 0.3}, {0.6 * w + 2, 0.3 * d + 1.6, top + 1.6}, all_sides & ~bottom_side);
        return;
    }
    gable_roof(m, -0.35, w + 0.35, -0.45, d + 0.45, top, 0.32 * d);
    const double chimney = w * random.uniform(0.2, 0.7);
    m.box({chimney, 0.62 * d, top + 0.2}, {chimney + 0.5, 0.62 * d + 0.5, top + 0.32 * d + 0.7},
          all_sides & ~bottom_side);
}

void house_rooms(Model& m, Random& random, const House& house) {
    const double x0 = wall_thickness, x1 = house.width - wall_thickness;
    const double y0 = wall_thickness, y1 = house.depth - wall_thickness;
    constexpr double thin = 0.12;
    for (int storey = 0; storey < house.storeys; ++storey) {
        const double floor = storey * storey_height + slab, ceiling = (storey + 1) * storey_height;
        const double spine = house.depth / 2 - thin / 2;
        // A wall from side to side, and one or two from it to the front and the back. None meets a window.
        {
            const bool right = random.below(2) == 1;
            const double at = random.uniform(1.2, 2.4) + (right ? house.width / 2 : 0);
            const WallOpening door{at - 0.45, at + 0.45, floor, floor + 2};
            const Inside place(m, {0, spine, 0});
            wall_panel(m, {x0, x1, floor, ceiling, thin}, std::span(&door, 1));
        }
        for (const bool back : {false, true}) {
            if (m.full()) return;
            const double low = back ? spine + thin : y0, high = back ? y1 : spine;
            const double middle = (low + high) / 2, deep = high - low;
            const auto furnish = [&](double left, double right) {
                if (m.full()) return;
                const Inside place(m, {(left + right) / 2, middle, floor}, back ? 0 : 180);
                furnish_room(m, random, right - left, deep);
            };
            if (random.below(3) == 0) {
                furnish(x0, x1);
                continue;
            }
            const double split = house.width / 2 + random.uniform(-0.25, 0.25);
            const double at = deep / 2;
            const WallOpening door{at - 0.45, at + 0.45, floor, floor + 2};
            {
                const Inside place(m, {split + thin / 2, low, 0}, 90);
                wall_panel(m, {0, deep, floor, ceiling, thin}, std::span(&door, 1));
            }
            furnish(x0, split - thin / 2);
            furnish(split + thin / 2, x1);
        }
    }
}

}  // namespace sightline
