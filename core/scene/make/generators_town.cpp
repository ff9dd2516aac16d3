// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/generators.h"
#include "core/scene/make/sketch.h"

namespace sightline {

namespace {

/// Houses along two opposite sides of a block, their fronts on the streets, yards with trees between them.
void houses(Sketch& sketch, Random& random, const RoomPlan& lot, const HouseStyle& style, bool yards) {
    for (const bool upper : {false, true}) {
        double x = lot.x0;
        while (lot.x1 - x >= 8) {
            double width = random.uniform(8, 14);
            if (lot.x1 - x - width < 8) width = lot.x1 - x;
            const double gap = random.below(3) == 0 ? random.uniform(1, 2.5) : 0.3;
            const double depth = random.uniform(9, 13);
            const double setback = random.uniform(0, 1.5);
            // The upper row is the lower one turned by half a turn.
            sketch.frame = upper ? turned({x + width, lot.y1 - setback}, 180) : turned({x, lot.y0 + setback}, 0);
            house(sketch, random, width - gap, depth, style);
            x += width;
        }
    }
    sketch.frame = {};
    if (!yards) return;
    const double middle = (lot.y0 + lot.y1) / 2;
    for (double x = lot.x0 + 3; x < lot.x1 - 3; x += random.uniform(4, 8)) {
        const double radius = random.uniform(1, 1.8), dy = random.uniform(-1.2, 1.2);
        tree(sketch, random, {x, middle + dy}, radius);
    }
}

void parked_car(Sketch& sketch, Random& random, const Vec<2>& centre) {
    sketch.frame = turned(centre, random.uniform(-2, 2));
    sketch.path(
        {{-2.1, -0.6}, {-1.9, -0.85}, {1.8, -0.85}, {2.15, -0.5}, {2.15, 0.5}, {1.8, 0.85}, {-1.9, 0.85}, {-2.1, 0.6}},
        true);
    sketch.line({0.7, -0.7}, {0.55, 0.7});
    sketch.line({-1.2, -0.7}, {-1.2, 0.7});
    sketch.frame = {};
}

}  // namespace

std::vector<Primitive<2>> streets(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    constexpr double width = 46, depth = 36, street = 14;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) {
            const double x = column * (width + street), y = row * (depth + street);
            if (row == 1 && column == 1) {  // a small park
                sketch.ring({x + width / 2, y + depth / 2}, 5, 24);
                sketch.ring({x + width / 2, y + depth / 2}, 4.5, 24);
                sketch.ring({x + width / 2, y + depth / 2}, 0.8, 8);
                for (int i = 0; i < 26; ++i) {
                    const SinCos turn = sincos_degrees(360.0 * i / 26);
                    const double far = random.uniform(1, 1.5);
                    tree(sketch, random, {x + width / 2 + 15 * far * turn.cos, y + depth / 2 + 10 * far * turn.sin},
                         random.uniform(1, 2));
                }
            } else {
                houses(sketch, random, {x, y, x + width, y + depth}, {}, true);
            }
            if (row == 0)
                for (int i = 0; i < 6; ++i)
                    if (random.below(2) == 0)
                        parked_car(sketch, random, {x + 6 + 7.5 * i, y + depth + (random.below(2) ? 2.0 : 12.0)});
        }
    return sketch.segments;
}

std::vector<Primitive<2>> city_blocks(std::size_t segments, std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    constexpr double width = 60, depth = 34, street = 14;
    constexpr double segments_a_block = 170;
    HouseStyle style;
    style.openings = style.furniture = false;
    const double blocks = static_cast<double>(segments) / segments_a_block;
    const double columns = std::ceil(std::sqrt(blocks * (depth + street) / (width + street)));
    for (double row = 0; sketch.segments.size() < segments; ++row)
        for (double column = 0; column < columns && sketch.segments.size() < segments; ++column) {
            const double x = column * (width + street), y = row * (depth + street);
            houses(sketch, random, {x, y, x + width, y + depth}, style, false);
        }
    sketch.segments.resize(segments);
    return sketch.segments;
}

namespace {

/// A row of rooms between x0 and x1: walls between them, and one wall with doors to the corridor at y = `corridor`.
void room_row(Sketch& sketch, Random& random, const RoomPlan& band, bool corridor_above) {
    const double corridor = corridor_above ? band.y1 : band.y0;
    std::vector<Opening> doors;
    double x = band.x0;
    while (x < band.x1) {
        double width = random.uniform(6, 12);
        if (band.x1 - x - width < 6) width = band.x1 - x;
        const RoomPlan room{x, band.y0, x + width, band.y1};
        const double door = random.uniform(1, width - 1);
        doors.push_back({x - band.x0 + door, 1.4});
        const double into = corridor_above ? -0.9 : 0.9;
        sketch.line({x + door - 0.7, corridor}, {x + door - 0.3, corridor + into});
        if (x > band.x0) sketch.line({x, band.y0}, {x, band.y1});
        const std::uint64_t kind = random.below(5);
        furnish(sketch, random, room, kind == 0 ? Furnishing::storage : Furnishing::office);
        x += width;
    }
    sketch.wall({band.x0, corridor}, {band.x1, corridor}, doors);
}

}  // namespace

std::vector<Primitive<2>> rooms(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // Corridors: y 15..19 and 45..49 across, x 46..50 up. The middle band has two rows, back to back.
    for (const auto& [x0, x1] : {std::pair(0.0, 46.0), std::pair(50.0, 96.0)}) {
        room_row(sketch, random, {x0, 0, x1, 15}, true);
        room_row(sketch, random, {x0, 19, x1, 32}, false);
        room_row(sketch, random, {x0, 32, x1, 45}, true);
        sketch.line({x0, 32}, {x1, 32});
        if (x0 == 0) room_row(sketch, random, {x0, 49, x1, 64}, false);
        const double side = x0 == 0 ? x1 : x0;  // walls along the corridor that goes up
        sketch.line({side, 0}, {side, 15});
        sketch.line({side, 19}, {side, 45});
        sketch.line({side, 49}, {side, 64});
    }
    // Instead of the last row, a hall with columns, open to the corridor between two piers.
    const Opening entrance{23, 20};
    sketch.wall({50, 49}, {96, 49}, std::span(&entrance, 1));
    for (int i = 0; i < 6; ++i)
        for (const double y : {53.5, 59.5}) sketch.ring({54 + 7.5 * i, y}, 0.5, 12);
    sketch.box(70, 55.5, 76, 57.5);
    // Outer walls, with windows.
    std::vector<Opening> windows, doors;
    for (int i = 0; i < 20; ++i) windows.push_back({2.5 + 4.8 * i, 1});
    for (const double y : {17.0, 47.0}) doors.push_back({y, 1.6});
    sketch.wall({0, 0}, {96, 0}, windows);
    sketch.wall({0, 64}, {96, 64}, windows);
    sketch.wall({0, 0}, {0, 64}, doors);
    sketch.wall({96, 0}, {96, 64}, doors);
    return sketch.segments;
}

}  // namespace sightline
