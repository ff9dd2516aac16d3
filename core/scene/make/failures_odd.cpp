// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/scene/make/failures_parts.h"
#include "core/scene/make/generators_failures.h"

namespace sightline::failures {

std::vector<Primitive<2>> planks(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (int i = 0; i < 20; ++i) {
        const double right = random.uniform(8, 39), left = random.uniform(8, 39);
        sketch.line({0, left}, {40, right});
        const double top = random.uniform(1, 39), bottom = random.uniform(1, 39);
        sketch.line({bottom, 8}, {top, 40});
    }
    crate_rows(sketch, random, {0, 0, 40, 40}, 3, 0.3);
    return sketch.segments;
}

std::vector<Primitive<2>> needles(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // 2 mm wide every 8 mm; a pixel of 8192 in a view of 60 degrees is 2.5 mm wide there.
    for (int i = 0; i < 1500; ++i) {
        const double x = 6 + 0.008 * i + random.uniform(0, 0.004);
        sketch.line({x, 18}, {x + 0.002, 18});
    }
    pieces(sketch, {0, 24}, {24, 24}, 48);
    sketch.line({0, 0}, {0.5, 0});
    sketch.line({23.5, 0}, {24, 0});
    return sketch.segments;
}

std::vector<Primitive<2>> cockpit(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // The eye is at (20, 4): bars 1 mm wide, 5 mm away.
    for (int i = 0; i < 5; ++i) sketch.line({19.9955 + 0.002 * i, 4.005}, {19.9965 + 0.002 * i, 4.005});
    pieces(sketch, {0, 0}, {0, 40}, 40);
    pieces(sketch, {0, 40}, {40, 40}, 40);
    pieces(sketch, {40, 0}, {40, 40}, 40);
    crate_rows(sketch, random, {1, 8, 39, 39}, 3, 0.3);
    return sketch.segments;
}

std::vector<Primitive<2>> graze(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    pieces(sketch, {5, 0}, {60, 0}, 110);
    pieces(sketch, {5, 4}, {60, 4}, 110);
    pieces(sketch, {60, 0}, {60, 4}, 16);
    for (int i = 0; i < 10; ++i) sketch.ring({8 + 5.0 * i, random.uniform(1, 3)}, 0.2, 8);
    crate_rows(sketch, random, {5, -12, 60, -1}, 1.5, 0.4);
    return sketch.segments;
}

std::vector<Primitive<2>> posters(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    const auto hang = [&](double y, double from, double to) {
        for (double x = from + 0.5; x + 1 < to; x += 1.5) sketch.line({x, y}, {x + random.uniform(0.3, 0.9), y});
    };
    // Half of the walls come before their posters, half behind them.
    for (int i = 0; i < 6; ++i) {
        const double y = 12.0 + 5 * i, from = i % 2 == 0 ? 0.0 : 20.5, to = from + 19.5;
        if (i % 2 == 0) sketch.line({from, y}, {to, y});
        hang(y, from, to);
        if (i % 2 == 1) sketch.line({from, y}, {to, y});
    }
    pieces(sketch, {0, 40}, {40, 40}, 40);
    pieces(sketch, {0, 0}, {40, 0}, 10);
    crate_rows(sketch, random, {0, 4, 40, 8}, 4, 0.15);
    return sketch.segments;
}

std::vector<Primitive<2>> broken(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    crate_rows(sketch, random, {0, 0, 40, 40}, 5, 0.3);
    const std::vector<Primitive<2>> good = sketch.segments;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 10; ++i) {
        const double y = random.uniform(0, 40), x = random.uniform(0, 40);
        const Vec<2> at(x, y);
        sketch.segments.push_back({at, Vec<2>(nan, at.y)});
        sketch.segments.push_back({Vec<2>(at.x, i % 2 == 0 ? infinite : -infinite), at});
        sketch.segments.push_back({at, at});
        sketch.segments.push_back(good[7 * i]);
    }
    return sketch.segments;
}

std::vector<Primitive<2>> booth(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // Closed but for a slit of 4 cm before the eye at (20, 20), from 2 cm beside it to 20 cm.
    sketch.path({{20.02, 20.2}, {20.2, 20.2}, {20.2, 19.9}, {19.98, 19.98}, {19.8, 19.9}, {19.8, 20.2}, {19.98, 20.2}},
                false);
    crate_rows(sketch, random, {1, 1, 39, 19}, 2, 0.4);
    crate_rows(sketch, random, {1, 22, 39, 39}, 2, 0.4);
    for (const double side : {0.0, 40.0}) {
        pieces(sketch, {0, side}, {40, side}, 40);
        pieces(sketch, {side, 0}, {side, 40}, 40);
    }
    return sketch.segments;
}

}  // namespace sightline::failures
