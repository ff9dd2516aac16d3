// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/failures_parts.h"
#include "core/scene/make/generators_failures.h"

namespace sightline::failures {

std::vector<Primitive<2>> empty(std::uint64_t) { return {}; }

std::vector<Primitive<2>> single(std::uint64_t) { return {{Vec<2>(-1, 5), Vec<2>(1, 5)}}; }

std::vector<Primitive<2>> onecell(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    sketch.line({0, 0}, {1, 0});
    sketch.line({39, 40}, {40, 40});
    for (int i = 0; i < 400; ++i) {
        const double y = random.uniform(21, 21.01), x = random.uniform(24, 24.01);
        const Vec<2> at(x, y);
        const SinCos turn = sincos_degrees(random.uniform(0, 360));
        sketch.line(at, at + 0.0005 * Vec<2>(turn.cos, turn.sin));
    }
    return sketch.segments;
}

std::vector<Primitive<2>> line(std::uint64_t) {
    Sketch sketch;
    for (int i = 0; i < 100; ++i) sketch.line({0.4 * i, 0}, {0.4 * i + 0.3, 0});
    return sketch.segments;
}

std::vector<Primitive<2>> lattice(std::uint64_t) {
    Sketch sketch;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) sketch.line({x + 0.375, y + 0.5}, {x + 0.625, y + 0.5});
    // Corners make the box a square whose halves are powers of two.
    sketch.line({0, 0}, {0.25, 0});
    sketch.line({31.75, 32}, {32, 32});
    return sketch.segments;
}

std::vector<Primitive<2>> meadow(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const SinCos turn = sincos_degrees(random.uniform(0, 360));
            const Vec<2> at(x + 0.5, y + 0.5), out(turn.cos * 0.02, turn.sin * 0.02);
            sketch.line(at - out, at + out);
        }
    return sketch.segments;
}

}  // namespace sightline::failures
