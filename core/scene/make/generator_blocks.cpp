// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/scene/make/generators.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/model.h"
#include "core/scene/make/plots.h"
#include "core/scene/make/route.h"

namespace sightline {

namespace {

// A plot is a block between the middle lines of four streets.
constexpr double block_pitch = 64, half_street = 6, block_side = block_pitch - 2 * half_street;

enum class RoofShape { flat, gable, hip };

/// A box over the parallelogram corner, corner + u, corner + u + 2 v, corner + 2 v, counter-clockwise; all of it
/// dyadic, so that the corners of a face lie in one plane exactly.
struct BlockPart {
    Vec<2> corner, u, v;
    double foot, top;
    RoofShape roof = RoofShape::flat;
    double rise = 0;
};

BlockPart part(const Vec<2>& middle, double width, double depth, double degrees, double foot, double height) {
    const Placement turn = turned({0, 0}, degrees);
    const Vec<2> u = dyadic(turn.at({width, 0})), v = dyadic(turn.at({0, depth / 2}));
    return {dyadic(middle - u * 0.5 - v), u, v, dyadic(foot), dyadic(foot + height)};
}

/// A building that stays in a square of side `lot`, turned by `degrees` as its street is.
void add_building(std::vector<BlockPart>& parts, Random& random, const Vec<2>& middle, double lot, double degrees) {
    double width = lot * random.uniform(0.72, 0.94), depth = lot * random.uniform(0.6, 0.94);
    if (random.below(20) < 9) {  // out of the line of the street
        const double angle = random.uniform(-40, 40);
        const SinCos turn = sincos_degrees(angle);
        const double s = std::abs(turn.sin), c = turn.cos;
        const double shrink =
            std::min({1.0, 0.95 * lot / (width * c + depth * s), 0.95 * lot / (width * s + depth * c)});
        width *= shrink, depth *= shrink, degrees += angle;
    }
    const std::uint64_t kind = random.below(20);
    if (kind < 8) {  // low, with a roof
        BlockPart house = part(middle, width, depth, degrees, 0, random.uniform(4, 9));
        house.roof = random.below(2) == 0 ? RoofShape::gable : RoofShape::hip;
        house.rise = dyadic(depth * random.uniform(0.25, 0.45));
        parts.push_back(house);
    } else if (kind < 17) {
        parts.push_back(part(middle, width, depth, degrees, 0, random.uniform(7, 24)));
    } else {  // a tower of boxes, each narrower than the one below
        double foot = 0, height = random.uniform(7, 15);
        for (std::uint64_t boxes = 2 + random.below(3); boxes > 0; --boxes) {
            parts.push_back(part(middle, width, depth, degrees, foot, height));
            foot = parts.back().top;
            width *= random.uniform(0.6, 0.9), depth *= random.uniform(0.6, 0.9);
            height = random.uniform(9, 24);
        }
    }
}

std::vector<BlockPart> block_parts(const Plot& plot, std::uint64_t seed) {
    Random random = plot.random(seed);
    const Vec<2> middle = block_pitch * Vec<2>(plot.x + 0.5, plot.y + 0.5);
    std::vector<BlockPart> parts;
    const std::uint64_t kind = random.below(20);
    if (kind < 2) {  // a park with one or two pavilions
        for (std::uint64_t left = 1 + random.below(2); left > 0; --left) {
            const Vec<2> at(left == 1 ? -12 : 12, random.uniform(-14, 14));
            add_building(parts, random, middle + at, random.uniform(8, 12), 0);
        }
    } else if (kind < 7) {  // two times two lots, turned as a whole
        const double size = random.uniform(8, 40), degrees = random.below(2) == 0 ? size : -size;
        const SinCos turn = sincos_degrees(degrees);
        const double lot = block_side / (2 * (turn.cos + std::abs(turn.sin)));
        const Placement frame = turned(middle, degrees);
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) add_building(parts, random, frame.at({lot * x, lot * y}), lot, degrees);
    } else {  // three times three lots round a court; a square has buildings at its corners only
        const bool square = kind < 9;
        constexpr double lot = block_side / 3;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                if ((x == 0 && y == 0) || (square && (x == 0 || y == 0))) continue;
                if (random.below(12) == 0) continue;
                add_building(parts, random, middle + lot * Vec<2>(x, y), lot, 0);
            }
    }
    return parts;
}

/// Walls and roof, fronts outward. It stands on something, so it has no floor.
void build(Model& m, const BlockPart& p) {
    const auto at = [](const Vec<2>& q, double z) { return Vec<3>(q.x, q.y, z); };
    const std::array<Vec<2>, 4> foot = {p.corner, p.corner + p.u, p.corner + p.u + 2.0 * p.v, p.corner + 2.0 * p.v};
    const Vec<3> left = at(p.corner + p.v, p.top + p.rise), right = at(p.corner + p.u + p.v, p.top + p.rise);
    const Vec<3> tip = at(p.corner + p.u * 0.5 + p.v, p.top + p.rise);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec<2>&a = foot[i], &b = foot[(i + 1) % 4];
        if (p.roof == RoofShape::gable && i % 2 == 1)  // up to the ridge
            m.polygon({at(a, p.foot), at(b, p.foot), at(b, p.top), i == 1 ? right : left, at(a, p.top)});
        else
            m.polygon({at(a, p.foot), at(b, p.foot), at(b, p.top), at(a, p.top)});
        if (p.roof == RoofShape::hip) m.triangle(at(a, p.top), at(b, p.top), tip);
    }
    if (p.roof == RoofShape::flat)
        m.polygon({at(foot[0], p.top), at(foot[1], p.top), at(foot[2], p.top), at(foot[3], p.top)});
    if (p.roof == RoofShape::gable) {
        m.polygon({at(foot[0], p.top), at(foot[1], p.top), right, left});
        m.polygon({at(foot[2], p.top), at(foot[3], p.top), left, right});
    }
}

}  // namespace

std::vector<Primitive<2>> blocks(std::uint64_t seed) {
    Sketch sketch;
    std::vector<Plot> plots = plots_by_distance(70);
    plots.resize(70);
    for (const Plot& plot : plots)
        for (const BlockPart& p : block_parts(plot, seed))
            if (p.foot == 0)
                sketch.path({p.corner, p.corner + p.u, p.corner + p.u + 2.0 * p.v, p.corner + 2.0 * p.v}, true);
    return sketch.segments;
}

namespace generate {

Generated blocks(std::uint64_t seed, std::size_t triangles) {
    constexpr std::size_t of_ground = 2, half_building = 8;
    Model model;
    double reach = 0;
    const auto full = [&] { return model.triangles.size() + of_ground + half_building > triangles; };
    for (const Plot& plot : plots_by_distance(triangles / 40 + 8)) {
        if (full()) break;
        reach = std::max({reach, std::abs(plot.x + 0.5), std::abs(plot.y + 0.5)});
        for (const BlockPart& p : block_parts(plot, seed)) {
            if (full() && p.foot == 0) break;  // but towers are finished
            build(model, p);
        }
    }
    reach = block_pitch * (reach + 0.5);
    model.polygon({{-reach, -reach, 0}, {reach, -reach, 0}, {reach, reach, 0}, {-reach, reach, 0}});

    Generated made;
    made.triangles = std::move(model.triangles);
    // From the middle of a street to a crossing near the origin, and on into another street.
    Random random(seed);
    const auto near = [&] { return block_pitch * (static_cast<double>(random.below(3)) - 1); };
    const Vec<2> crossing(near(), near());
    const std::array<Vec<2>, 4> ways = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const std::size_t from = random.below(4), to = (from + 1 + random.below(3)) % 4;
    std::vector<Vec<2>> way{crossing + 14.0 * ways[from]};
    stroll(way, crossing, random, 2);
    stroll(way, crossing + block_pitch * ways[to], random, 2);
    made.paths.push_back(on_foot("walk", way, 480));
    made.paths.push_back(on_foot("line", std::array{Vec<2>(-8, 0), Vec<2>(8, 0)}, 320));
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace generate

}  // namespace sightline
