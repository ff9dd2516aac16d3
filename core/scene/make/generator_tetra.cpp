// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/scene/make/generators.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/model.h"
#include "core/scene/make/route.h"
#include "core/scene/make/scatter.h"

namespace sightline {

namespace {

/// From the middle to the corners.
constexpr double smallest_tetra = 1, largest_tetra = 3.2;
constexpr double clear_of_way = 0.6;

struct TetraWays {
    FlightPath<3> walk, line;

    std::vector<Vec<2>> points() const {
        std::vector<Vec<2>> all;
        for (const FlightPath<3>* path : {&walk, &line})
            for (const ViewSpec<3>& frame : path->frames) all.emplace_back(frame.eye.x, frame.eye.y);
        return all;
    }
};

/// The ways come first, and what stands on them is left out.
TetraWays tetra_ways(std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec<2>> way{{-6, -9}};
    Vec<2> heading(1, 0);
    for (int i = 0; i < 12; ++i) {
        const Placement turn = turned({0, 0}, random.uniform(-40, 40));
        heading = turn.at(heading);
        way.push_back(way.back() + 3.0 * heading);
    }
    return {on_foot("walk", way, 480), on_foot("line", std::array{Vec<2>(-8, 0), Vec<2>(8, 0)}, 320)};
}

std::vector<Stand> tetra_stands(std::uint64_t seed, std::size_t count, const TetraWays& ways) {
    const std::vector<Vec<2>> points = ways.points();
    return scatter(seed, count, smallest_tetra, largest_tetra, points, clear_of_way);
}

/// Where x, y and z go when turned in any way, all of them alike: a unit quaternion out of the ball.
std::array<Vec<3>, 3> random_turn(Random& random) {
    double w, x, y, z, square;
    do {
        w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        square = w * w + x * x + y * y + z * z;
    } while (square > 1 || square < 0.01);
    const double s = 2 / square;
    return {{{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
             {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
             {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}}};
}

}  // namespace

std::vector<Primitive<2>> tetra(std::uint64_t seed) {
    Sketch sketch;
    for (Stand& stand : tetra_stands(seed, 900, tetra_ways(seed))) {
        const double first = stand.random.uniform(0, 360);
        std::array<Vec<2>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const SinCos turn = sincos_degrees(first + 120 * static_cast<double>(i) + stand.random.uniform(-30, 30));
            corners[i] = stand.centre + stand.radius * Vec<2>(turn.cos, turn.sin);
        }
        sketch.path(corners, true);
    }
    return sketch.segments;
}

namespace generate {

Generated tetra(std::uint64_t seed, std::size_t triangles) {
    TetraWays ways = tetra_ways(seed);
    Model model;
    double reach = 0;
    for (Stand& stand : tetra_stands(seed, (triangles - 2) / 4, ways)) {
        // A regular one with its corners moved a little toward its middle, lowest corner on the ground.
        static constexpr double third = 0.57735026918962576;  // 1 / sqrt(3)
        const auto [x, y, z] = random_turn(stand.random);
        std::array<Vec<3>, 4> corners = {
            {{third, third, third}, {-third, -third, third}, {-third, third, -third}, {third, -third, -third}}};
        double lowest = 0;
        for (Vec<3>& corner : corners) {
            corner = (corner.x * x + corner.y * y + corner.z * z) * (stand.radius * stand.random.uniform(0.7, 1));
            lowest = std::min(lowest, corner.z);
        }
        for (Vec<3>& corner : corners) corner += Vec<3>(stand.centre.x, stand.centre.y, -lowest);
        const auto& [a, b, c, d] = corners;
        model.triangle(a, c, b);
        model.triangle(a, b, d);
        model.triangle(b, c, d);
        model.triangle(c, a, d);
        reach = std::max({reach, std::abs(stand.centre.x), std::abs(stand.centre.y)});
    }
    reach += 2 * largest_tetra;
    model.polygon({{-reach, -reach, 0}, {reach, -reach, 0}, {reach, reach, 0}, {-reach, reach, 0}});

    Generated made;
    made.triangles = std::move(model.triangles);
    made.paths = {std::move(ways.walk), std::move(ways.line)};
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace generate

}  // namespace sightline
