// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/generators.h"
#include "core/scene/make/sketch.h"

namespace sightline {

namespace {

/// Rows of crates and shelves between x0 and x1.
void store(Sketch& sketch, Random& random, const RoomPlan& area, double spacing) {
    for (double y = area.y0 + spacing / 2; y < area.y1; y += spacing)
        for (double x = area.x0 + spacing / 2; x < area.x1; x += spacing) {
            const double side = spacing * random.uniform(0.35, 0.6);
            const double dx = random.uniform(-0.1, 0.1), dy = random.uniform(-0.1, 0.1);
            crate(sketch, random, {x + dx * spacing, y + dy * spacing}, side);
        }
}

}  // namespace

std::vector<Primitive<2>> bottleneck(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // Every corner of the quadtree costs cells: what there is keeps to seven of its sixteen leaves' parents.
    const auto pieces = [&](const Vec<2>& a, const Vec<2>& b, int count) {
        // Walls in short pieces: a budget of a few primitives must not show all of one.
        for (int i = 0; i < count; ++i)
            sketch.line(a + (b - a) * (static_cast<double>(i) / count),
                        i + 1 == count ? b : a + (b - a) * (static_cast<double>(i + 1) / count));
    };
    // Two blocks full of crates, their backs lower at the outer ends; x is the distance from the middle of the gap.
    constexpr double gap = 0.95, end = 7.95, front = 4.3, back = 7.75, outer_back = 7.405, spacing = 0.85;
    for (const double side : {-1.0, 1.0}) {
        const auto at = [side](double x, double y) { return Vec<2>(8 + side * x, y); };
        pieces(at(gap, front), at(end, front), 6);
        pieces(at(end, front), at(end, outer_back), 2);
        pieces(at(end, outer_back), at(gap, back), 6);
        pieces(at(gap, back), at(gap, front), 4);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 8; ++column) {
                const double x = gap + spacing * (column + 0.6), y = front + spacing * (row + 0.6);
                const double roof = back + (outer_back - back) * (x + 0.3 - gap) / (end - gap);
                if (x > end - 0.4 * spacing || y + 0.35 * spacing > roof) continue;
                const double dy = random.uniform(-0.1, 0.1), dx = random.uniform(-0.1, 0.1);
                crate(sketch, random, at(x, y) + spacing * Vec<2>(dx, dy), spacing * random.uniform(0.35, 0.55));
            }
        // Behind the block and hidden by it.
        for (const Vec<2>& crates : {Vec<2>(3.1, 12.5), Vec<2>(3.5, 15)})
            crate(sketch, random, at(crates.x, crates.y), 0.85);
    }
    // Beyond the gap a house, whose front can be seen; behind the viewer a bench.
    pieces({5.75, 12.45}, {10.25, 12.45}, 14);
    sketch.path({{5.75, 12.45}, {5.75, 16}, {10.25, 16}, {10.25, 12.45}}, false);
    sketch.box(4.4, 0, 5.6, 0.4);
    return sketch.segments;
}

std::vector<Primitive<2>> field(std::uint64_t seed) {
    std::vector<Primitive<2>> segments = bottleneck(seed);
    // Its four corners are all that the field has. The tree's root is then four times as wide, so that leaves of 5 %
    // are those that the bottleneck by itself has at 24 %.
    for (const double x : {-16.0, 48.0})
        for (const double y : {-16.0, 48.0}) {
            const Vec<2> corner(x, y);
            segments.push_back({corner, corner + Vec<2>(x < 0 ? 1 : -1, 0)});
            segments.push_back({corner, corner + Vec<2>(0, y < 0 ? 1 : -1)});
        }
    return segments;
}

std::vector<Primitive<2>> wallholes(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    // A wall of planks 12 cm thick; what is left open between them is a hole.
    double x = 0;
    while (x < 40) {
        double end = x + random.uniform(0.9, 2.4);
        if (end > 39) end = 40;
        sketch.box(x, 14, end, 14.12);
        x = end + random.uniform(0.06, 0.3);
    }
    sketch.path({{0, 14.12}, {0, 40}, {40, 40}, {40, 14.12}}, false);
    store(sketch, random, {2, 19, 38, 38}, 2.0);
    for (int i = 0; i < 4; ++i) crate(sketch, random, {6 + 9.5 * i, random.uniform(6, 10)}, 0.8);
    sketch.path({{0, 14}, {0, 0}, {40, 0}, {40, 14}}, false);
    return sketch.segments;
}

std::vector<Primitive<2>> wall2(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    sketch.path({{3, 13.5}, {20, 14.5}, {37, 13.5}}, false);
    store(sketch, random, {1, 18, 39, 39}, 1.7);
    // What can be seen: a bench, lamp posts, planters beside the ends of the wall.
    sketch.box(17, 9, 19, 9.5);
    for (int i = 0; i < 5; ++i) sketch.ring({4 + 8.0 * i, 11.5}, 0.2, 8);
    for (const double x : {0.5, 38.3})
        for (int i = 0; i < 4; ++i) tree(sketch, random, {x + 0.6, 2.0 + 2.5 * i}, 0.8);
    sketch.path({{0, 15}, {0, 0}, {40, 0}, {40, 15}}, false);
    sketch.path({{0, 15}, {0, 40}, {40, 40}, {40, 15}}, false);
    return sketch.segments;
}

std::vector<Primitive<2>> forget(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    sketch.box(0, 19, 0.4, 21);  // a bench behind the viewer
    // On the left a wall of bricks, in bond: nothing behind it can be seen. Together with the reeds it goes from side
    // to side of the view, so there is no way round.
    for (int course = 0; course < 2; ++course)
        for (int brick = 0; brick < 14; ++brick) {
            const double x = 12 + 0.35 * course, y = 20.05 + 1.1 * brick + (course == 0 ? 0.0 : 0.55);
            sketch.box(x, y, x + 0.3, y + 1.05);
        }
    // Far behind it, a store.
    store(sketch, random, {58, 21, 72, 40}, 1.6);
    // On the right reeds: many, but so thin that one looks deep into them.
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 30; ++column) {
            const double dy = random.uniform(-0.4, 0.4), dx = random.uniform(-0.4, 0.4);
            const Vec<2> at(10.2 + 0.33 * (column + dx), 9.9 + 0.33 * (row + dy));
            const SinCos turn = sincos_degrees(random.uniform(0, 360));
            sketch.line(at, at + random.uniform(0.04, 0.08) * Vec<2>(turn.cos, turn.sin));
        }
    return sketch.segments;
}

namespace {

/// A valley: a parabola with gentle waves, low enough that no slope turns away from a viewer above the middle.
double slope(double x) {
    const double from_middle = x - 100;
    return 0.0042 * from_middle * from_middle + 1.1 * sincos_degrees(9 * x).sin + 0.5 * sincos_degrees(23 * x).sin;
}

}  // namespace

std::vector<Primitive<2>> terrain(std::uint64_t seed) {
    Random random(seed);
    Sketch sketch;
    const auto on_ground = [](double x) { return Vec<2>(x, slope(x)); };
    double x = 0;
    while (x < 200) {
        const bool left = x < 100;
        const double toward = left ? 1 : -1;  // the way down to the middle
        const std::uint64_t kind = random.below(5);
        if (kind == 0 && x > 8 && x < 188 && std::abs(x - 100) > 12) {
            // A house dug into the slope: its front faces the valley, its roof comes down to the ground behind.
            const double width = random.uniform(4, 7), height = random.uniform(2.4, 4);
            const Vec<2> a = on_ground(x), b = on_ground(x + width);
            const Vec<2> foot = left ? b : a, back = left ? a : b;
            const Vec<2> eaves(foot.x, std::max(foot.y, back.y - 1) + height);
            const Vec<2> ridge(foot.x - toward * width * 0.5, eaves.y + 1.2);
            const Vec<2> sill(foot.x, foot.y + 0.5 * (eaves.y - foot.y)), balcony(foot.x + toward * 0.8, sill.y);
            sketch.path({foot, sill, balcony, {balcony.x, balcony.y + 0.7}}, false);
            sketch.line(sill, eaves);
            for (int i = 0; i < 4; ++i) {  // courses of tiles
                sketch.line(eaves + (ridge - eaves) * (i / 4.0), eaves + (ridge - eaves) * ((i + 1) / 4.0));
                sketch.line(ridge + (back - ridge) * (i / 4.0), ridge + (back - ridge) * ((i + 1) / 4.0));
            }
            x += width;
        } else if (kind == 1 && x < 196) {
            // A bush: the upper part of a circle, nowhere steeper than 45 degrees to the ground.
            const double width = random.uniform(2, 4);
            const Vec<2> a = on_ground(x), b = on_ground(x + width);
            std::vector<Vec<2>> crown{a};
            for (int i = 1; i < 8; ++i) {
                const double share = i / 8.0;
                crown.push_back(a + (b - a) * share + Vec<2>(0, width * share * (1 - share) * (i % 2 == 0 ? 0.85 : 1)));
            }
            crown.push_back(b);
            sketch.path(crown, false);
            x += width;
        } else {
            const double length = random.uniform(1.5, 4);
            const int pieces = static_cast<int>(length / 0.4);
            for (int i = 0; i < pieces; ++i)
                sketch.line(on_ground(x + length * i / pieces), on_ground(x + length * (i + 1) / pieces));
            x += length;
        }
    }
    return sketch.segments;
}

}  // namespace sightline
