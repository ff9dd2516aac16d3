// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/failures_parts.h"
#include "core/scene/make/generators_failures.h"

namespace sightline::failures {

std::vector<Primitive<2>> fence(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (int i = 0; i < 40; ++i) {
        const double from = i + 0.1, to = i + 0.9;
        sketch.line({from, 0}, {to, 0});
        sketch.line({from, 40}, {to, 40});
        sketch.line({0, from}, {0, to});
        sketch.line({40, from}, {40, to});
    }
    // Corners, so that the fence is the border of the box.
    for (const double x : {0.0, 40.0})
        for (const double y : {0.0, 40.0}) sketch.line({x, y}, {x, y + (y > 0 ? -0.05 : 0.05)});
    crate_rows(sketch, random, {6, 6, 34, 34}, 5, 0.2);
    return sketch.segments;
}

std::vector<Primitive<2>> warehouse(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    pieces(sketch, {0, 0}, {60, 0}, 80);
    pieces(sketch, {0, 0}, {0, 30}, 20);
    pieces(sketch, {60, 0}, {60, 30}, 20);
    crate_rows(sketch, random, {0.5, 0.5, 59.5, 29.5}, 1.6, 0.5);
    return sketch.segments;
}

std::vector<Primitive<2>> corner(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (const double x0 : {-20.0, 8.0}) {
        const double x1 = x0 + 22;
        pieces(sketch, {x0, 6}, {x1, 6}, 44);
        pieces(sketch, {x0, 6}, {x0, 30}, 48);
        pieces(sketch, {x1, 6}, {x1, 30}, 48);
        pieces(sketch, {x0, 30}, {x1, 30}, 44);
        crate_rows(sketch, random, {x0 + 0.5, 6.5, x1 - 0.5, 29.5}, 2, 0.4);
    }
    pieces(sketch, {-20, 37}, {30, 37}, 100);  // what closes the view through the street
    return sketch.segments;
}

std::vector<Primitive<2>> niche(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    pieces(sketch, {15, 0}, {15, 8}, 8);
    pieces(sketch, {25, 0}, {25, 8}, 8);
    pieces(sketch, {15, 8}, {25, 8}, 10);
    crate_rows(sketch, random, {1, 0, 13, 39}, 2, 0.4);
    crate_rows(sketch, random, {27, 0, 39, 39}, 2, 0.4);
    pieces(sketch, {0, 40}, {40, 40}, 40);
    for (const double x : {0.0, 40.0}) pieces(sketch, {x, 0}, {x, 40}, 20);
    return sketch.segments;
}

}  // namespace sightline::failures
