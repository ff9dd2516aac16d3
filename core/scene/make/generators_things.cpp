// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/car_parts.h"
#include "core/scene/make/generators.h"
#include "core/scene/make/sketch.h"

namespace sightline {

namespace {

void tyre(Sketch& s, double x, double y) {
    s.box(x - 0.32, y - 0.1, x + 0.32, y + 0.1);
    for (int i = -2; i <= 2; ++i) s.line({x + 0.1 * i, y - 0.07}, {x + 0.1 * i, y + 0.07});
}

void seat(Sketch& s, double x, double y) {
    s.path({{x - 0.2, y - 0.22},
            {x + 0.25, y - 0.22},
            {x + 0.28, y - 0.15},
            {x + 0.28, y + 0.15},
            {x + 0.25, y + 0.22},
            {x - 0.2, y + 0.22}},
           true);
    s.box(x - 0.32, y - 0.2, x - 0.23, y + 0.2);
    s.box(x - 0.45, y - 0.1, x - 0.36, y + 0.1);
}

void engine_block(Sketch& s, Random& random) {
    s.box(1.0, -0.42, 1.85, 0.42);  // block
    const int cylinders = random.below(2) == 0 ? 2 : 3;
    for (int i = 0; i < cylinders; ++i)
        for (const double y : {-0.22, 0.22}) {
            const double x = 1.0 + 0.85 * (i + 0.5) / cylinders;
            s.ring({x, y}, 0.13, 10);
            s.ring({x, y}, 0.09, 10, 18);
            s.ring({x, y}, 0.03, 5);
        }
    s.line({1.02, 0}, {1.83, 0});
    s.box(1.9, -0.55, 1.98, 0.55);  // radiator and its fins
    for (int i = 0; i < 18; ++i) s.line({1.91, -0.52 + 0.06 * i}, {1.97, -0.52 + 0.06 * i});
    s.box(1.05, 0.5, 1.4, 0.68);  // battery
    s.ring({1.12, 0.59}, 0.03, 6);
    s.ring({1.33, 0.59}, 0.03, 6);
    s.ring({1.3, -0.57}, 0.1, 9);  // filter
    s.ring({1.3, -0.57}, 0.06, 9);
    s.path({{1.45, 0.47}, {1.6, 0.55}, {1.8, 0.5}, {1.88, 0.5}}, false);  // hoses
    s.path({{1.42, -0.5}, {1.6, -0.55}, {1.75, -0.48}, {1.88, -0.5}}, false);
    s.path({{0.98, -0.25}, {0.6, -0.12}, {0.35, -0.1}, {0.35, 0.1}, {0.6, 0.12}, {0.98, 0.25}}, false);  // gearbox
}

/// Seen from above, 4.4 by 1.8, its nose toward +x. `parts` is kept in step with the segments.
void put_car(Sketch& s, Random& random, std::vector<CarPart>& parts) {
    static constexpr Vec<2> half[] = {{2.2, 0.0},  {2.18, 0.4},  {2.08, 0.68}, {1.85, 0.85}, {1.3, 0.9}, {0.0, 0.88},
                                      {-1.4, 0.9}, {-1.9, 0.84}, {-2.12, 0.7}, {-2.2, 0.42}, {-2.2, 0.0}};
    std::vector<Vec<2>> shell(std::begin(half), std::end(half));
    for (std::size_t i = std::size(half) - 2; i > 0; --i) shell.push_back({half[i].x, -half[i].y});
    for (const double size : {1.0, 0.97}) {
        for (Vec<2>& p : shell) p *= size;
        s.path(shell, true);
        for (std::size_t i = 0; i < shell.size(); ++i)
            parts.push_back(shell[i].x + shell[(i + 1) % shell.size()].x > 0 ? CarPart::front : CarPart::back);
    }
    for (const double side : {-1.0, 1.0}) {
        s.path({{0.55, side * 0.92}, {0.5, side * 1.08}, {0.42, side * 1.08}, {0.4, side * 0.92}}, true);  // mirror
        parts.resize(s.segments.size(), CarPart::front);
        for (const double x : {-1.35, 1.4}) tyre(s, x, side * 0.74);
        parts.resize(s.segments.size(), CarPart::other);
    }
    engine_block(s, random);
    parts.resize(s.segments.size(), CarPart::engine);
    s.path({{0.78, -0.66}, {0.9, -0.3}, {0.92, 0.0}, {0.9, 0.3}, {0.78, 0.66}}, false);  // windscreen
    s.path({{0.35, -0.66}, {0.5, -0.3}, {0.5, 0.3}, {0.35, 0.66}}, false);               // dashboard
    s.path({{-1.05, -0.64}, {-1.12, -0.3}, {-1.12, 0.3}, {-1.05, 0.64}}, false);         // rear window
    for (const double y : {-0.35, 0.35}) seat(s, -0.05, y);
    for (const double y : {-0.46, 0.0, 0.46}) seat(s, -0.8, y);
    s.ring({0.36, 0.35}, 0.14, 12);  // steering wheel, inside the dashboard's bow
    s.ring({-1.65, 0}, 0.28, 14);    // spare wheel
    s.ring({-1.65, 0}, 0.17, 14);
    s.box(-2.0, -0.55, -1.4 + random.uniform(0, 0.1), -0.32);  // luggage
    s.box(-2.0, 0.32, -1.75, 0.55);
    s.box(-1.7, 0.32, -1.45 + random.uniform(0, 0.1), 0.55);
    parts.resize(s.segments.size(), CarPart::other);
}

struct CarPark {
    Sketch sketch;
    std::vector<CarPart> parts;
};

CarPark car_park(std::uint64_t seed) {
    Random random(seed);
    CarPark park;
    Sketch& sketch = park.sketch;
    // Two rows of a car park, noses toward the lane, one space left free.
    for (int row = 0; row < 2; ++row)
        for (int space = 0; space < 5; ++space) {
            if (row == 0 && space == 3) continue;
            const Vec<2> centre(3.2 + 4.6 * space + random.uniform(-0.2, 0.2), row == 0 ? 3.5 : 13.5);
            sketch.frame = turned(centre, (row == 0 ? 62 : -62) + random.uniform(-3, 3));
            put_car(sketch, random, park.parts);
        }
    // A ticket machine and lamp posts.
    sketch.frame = {};
    sketch.box(25.2, 8.0, 25.8, 8.8);
    for (int i = 0; i < 4; ++i) sketch.ring({1 + 7.6 * i, 16.6}, 0.15, 8);
    park.parts.resize(sketch.segments.size(), CarPart::none);
    return park;
}

}  // namespace

std::vector<Primitive<2>> cars(std::uint64_t seed) { return car_park(seed).sketch.segments; }

std::vector<CarPart> car_parts(std::uint64_t seed) { return car_park(seed).parts; }

std::vector<Primitive<2>> jungle(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    constexpr double size = 40;
    const Vec<2> clearing(20, 7);
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) {
            const double in_row = random.uniform(0.25, 0.75), in_column = random.uniform(0.25, 0.75);
            const Vec<2> trunk(size * (column + in_column) / 9, size * (row + in_row) / 9);
            if (glm::dot(trunk - clearing, trunk - clearing) < 12) continue;
            const double crown = random.uniform(1.3, 2.4);
            // Strips of bark, then leaves along branches; each is a segment of its own.
            for (int i = 0; i < 6; ++i) {
                const SinCos a = sincos_degrees(60.0 * i + 5), b = sincos_degrees(60.0 * i + 55);
                const double radius = crown * 0.12;
                sketch.line(trunk + radius * Vec<2>(a.cos, a.sin), trunk + radius * Vec<2>(b.cos, b.sin));
            }
            for (int branch = 0; branch < 9; ++branch) {
                const double angle = 40.0 * branch + random.uniform(-12, 12);
                for (int leaf = 0; leaf < 5; ++leaf) {
                    const SinCos out = sincos_degrees(angle + random.uniform(-9, 9));
                    const Vec<2> at = trunk + crown * (0.3 + 0.16 * leaf) * Vec<2>(out.cos, out.sin);
                    const SinCos turn = sincos_degrees(angle + (leaf % 2 == 0 ? 50 : -50) + random.uniform(-20, 20));
                    sketch.line(at, at + random.uniform(0.15, 0.32) * Vec<2>(turn.cos, turn.sin));
                }
            }
        }
    for (int i = 0; i < 500; ++i) {  // undergrowth
        const double y = random.uniform(0, size), x = random.uniform(0, size);
        const Vec<2> at(x, y);
        const SinCos turn = sincos_degrees(random.uniform(0, 360));
        if (glm::dot(at - clearing, at - clearing) > 5)
            sketch.line(at, at + random.uniform(0.05, 0.15) * Vec<2>(turn.cos, turn.sin));
    }
    return sketch.segments;
}

std::vector<Primitive<2>> statue(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // The statue stands in the middle of the gallery, on the diagonal of the square between four leaf centres: halved
    // three times, the 40 m square has leaves of 5 m. Whoever goes up the gallery passes through one of its two cells.
    const Vec<2> centre(25, 25);
    for (int layer = 0; layer < 8; ++layer) {
        std::vector<Vec<2>> contour;
        const double radius = 1.2 - 0.13 * layer;
        for (int i = 0; i < 120; ++i) {
            const SinCos turn = sincos_degrees(3.0 * i), fold = sincos_degrees(15.0 * i + 20 * layer);
            const double r = radius * (0.84 + 0.12 * fold.sin + random.uniform(-0.02, 0.02));
            contour.push_back(centre + r * Vec<2>(turn.cos, turn.sin));
        }
        sketch.path(contour, true);
    }
    // The hall, the gallery that leads away from it, and a store room on either side, which nobody can look into.
    const Opening door{20, 2.4}, arch{25, 5};
    sketch.wall({0, 0}, {40, 0}, std::span(&door, 1));
    sketch.path({{0, 0}, {0, 40}, {40, 40}, {40, 0}}, false);
    sketch.wall({0, 18}, {40, 18}, std::span(&arch, 1));
    for (const double x : {22.5, 27.5}) sketch.line({x, 18}, {x, 40});
    for (const RoomPlan& area : {RoomPlan{1, 20, 21.5, 39}, RoomPlan{28.5, 20, 39, 39}})
        for (double y = area.y0 + 1; y < area.y1; y += 2.2)
            for (double x = area.x0 + 1; x < area.x1; x += 2.2) {
                const double side = random.uniform(0.8, 1.3);
                const double dx = random.uniform(-0.2, 0.2), dy = random.uniform(-0.2, 0.2);
                crate(sketch, random, {x + dx, y + dy}, side);
            }
    // Panels along the gallery and a show case at its end.
    for (int i = 0; i < 5; ++i) {
        sketch.box(22.6, 28 + 2.3 * i, 22.75, 29.4 + 2.3 * i);
        sketch.box(27.25, 28 + 2.3 * i, 27.4, 29.4 + 2.3 * i);
    }
    for (int i = 0; i < 4; ++i) sketch.box(23 + 1.1 * i, 38.8, 23.8 + 1.1 * i, 39.4);
    // In the hall: pillars, benches, visitors with shoulders and a head.
    for (const double y : {6.0, 14.0})
        for (const double x : {8.0, 33.0}) sketch.ring({x, y}, 0.6, 12);
    for (const double x : {17.0, 30.0}) sketch.box(x, 11, x + 2, 11.6);
    for (int i = 0; i < 7; ++i) {
        const double degrees = random.uniform(0, 360);
        const double x = random.uniform(12, 21), y = random.uniform(11, 16);
        sketch.frame = turned({x, y}, degrees);
        sketch.path({{-0.25, -0.1}, {0.25, -0.1}, {0.28, 0.05}, {-0.28, 0.05}}, true);
        sketch.ring({0, 0.16}, 0.1, 6);
    }
    return sketch.segments;
}

}  // namespace sightline
