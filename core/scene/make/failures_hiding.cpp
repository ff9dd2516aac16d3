// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/failures_parts.h"
#include "core/scene/make/generators_failures.h"

namespace sightline::failures {

namespace {

void leaves(Sketch& sketch, Random& random, const Vec<2>& centre, double radius, int count, double length) {
    for (int i = 0; i < count; ++i) {
        const SinCos out = sincos_degrees(random.uniform(0, 360)), turn = sincos_degrees(random.uniform(0, 360));
        const Vec<2> at = centre + radius * random.unit() * Vec<2>(out.cos, out.sin);
        sketch.line(at, at + length * random.uniform(0.6, 1) * Vec<2>(turn.cos, turn.sin));
    }
}

}  // namespace

std::vector<Primitive<2>> thicket(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    leaves(sketch, random, {20, 12}, 1.5, 900, 0.12);
    pieces(sketch, {0, 40}, {40, 40}, 60);
    pieces(sketch, {0, 0}, {0, 40}, 20);
    pieces(sketch, {40, 0}, {40, 40}, 20);
    crate_rows(sketch, random, {14, 33, 26, 38}, 1.5, 0.4);
    return sketch.segments;
}

std::vector<Primitive<2>> zigzag(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    std::vector<Vec<2>> folds;
    for (int i = 0; i <= 24; ++i) folds.push_back({2 + 1.5 * i, i % 2 == 0 ? 14.0 : 16.5});
    sketch.path(folds, false);
    // Each fold has a buttress that starts in the joint: three walls meet there.
    for (int i = 1; i < 24; i += 2) sketch.line(folds[static_cast<std::size_t>(i)], {2 + 1.5 * i, 18});
    crate_rows(sketch, random, {1, 19, 39, 39}, 1.7, 0.4);
    for (const double x : {0.0, 40.0}) sketch.line({x, 0}, {x, 40});
    return sketch.segments;
}

std::vector<Primitive<2>> ridge(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (int i = 0; i < 6; ++i) {
        const double x = 4 + 6.0 * i, toward = x < 20 ? 1 : -1;
        // Both walls lie on one side of the ray through their common edge.
        const Vec<2> edge(x + toward * 1.2, 14);
        sketch.path({{x - toward * 1.2, 14.5}, edge, {x - toward * 0.4, 18}}, false);
        leaves(sketch, random, {x + toward * 2.6, 20}, 0.8, 30, 0.3);
        crate(sketch, random, {x, 20}, 0.6);
    }
    pieces(sketch, {0, 40}, {40, 40}, 40);
    for (const double x : {0.0, 40.0}) sketch.line({x, 0}, {x, 40});
    return sketch.segments;
}

std::vector<Primitive<2>> fog(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (int i = 0; i < 70; ++i) {
        const double y = random.uniform(8, 30), x = random.uniform(20, 40);
        const Vec<2> at(x, y);
        const SinCos turn = sincos_degrees(random.uniform(-40, 40));
        sketch.line(at, at + random.uniform(0.25, 0.45) * Vec<2>(turn.cos, turn.sin));
    }
    pieces(sketch, {5, 56}, {55, 56}, 1000);
    crate_rows(sketch, random, {1, 57, 59, 60}, 1.4, 0.4);
    sketch.line({0, 0}, {0, 1});
    sketch.line({60, 59}, {60, 60});
    return sketch.segments;
}

std::vector<Primitive<2>> gap(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    pieces(sketch, {0, 14}, {19.96, 14}, 40);
    pieces(sketch, {20.04, 14}, {40, 14}, 40);
    crate_rows(sketch, random, {1, 16, 19, 39}, 1.5, 0.4);
    crate_rows(sketch, random, {21, 16, 39, 39}, 1.5, 0.4);
    // The eye at (20, 4) sees a strip 20 cm wide of it.
    for (int layer = 0; layer < 4; ++layer) sketch.ring({20, 30}, 0.4 - 0.09 * layer, 40, 3.0 * layer);
    pieces(sketch, {0, 40}, {40, 40}, 20);
    for (const double x : {0.0, 40.0}) pieces(sketch, {x, 0}, {x, 40}, 10);
    return sketch.segments;
}

}  // namespace sightline::failures
