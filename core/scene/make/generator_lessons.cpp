// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/furniture.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

constexpr unsigned standing = all_sides & ~unsigned{bottom_side};

/// A closed block whose upright sides are cut into pieces, so that a small budget must not show all of one.
void block(Model& m, const Vec<3>& low, const Vec<3>& high, int pieces_x, int pieces_y, int pieces_z) {
    const auto side = [&](const Vec<3>& corner, const Vec<3>& along, int pieces) {
        const Vec<3> up(0, 0, high.z - low.z);
        for (int i = 0; i < pieces; ++i)
            for (int k = 0; k < pieces_z; ++k) {
                const auto at = [&](int column, int row) {
                    return corner + along * (static_cast<double>(column) / pieces) +
                           up * (static_cast<double>(row) / pieces_z);
                };
                m.polygon({at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
            }
    };
    const double x = high.x - low.x, y = high.y - low.y;
    side({low.x, low.y, low.z}, {x, 0, 0}, pieces_x);
    side({high.x, low.y, low.z}, {0, y, 0}, pieces_y);
    side({high.x, high.y, low.z}, {-x, 0, 0}, pieces_x);
    side({low.x, high.y, low.z}, {0, -y, 0}, pieces_y);
    m.box(low, high, top_side);
}

/// Crates on `layers` floors inside an area, none touching another.
void crates(Model& m, Random& random, const Vec<2>& low, const Vec<2>& high, double spacing, int layers) {
    for (int layer = 0; layer < layers; ++layer)
        for (double y = low.y + spacing / 2; y + spacing / 2 <= high.y; y += spacing)
            for (double x = low.x + spacing / 2; x + spacing / 2 <= high.x; x += spacing) {
                const double side = spacing * random.uniform(0.35, 0.6), z = layer * spacing;
                const Inside place(m, {x, y, z}, random.uniform(0, 90));
                m.box({-side / 2, -side / 2, 0}, {side / 2, side / 2, side}, layer == 0 ? standing : all_sides);
            }
}

FlightPath<3> sideways(const Vec<3>& from, const Vec<3>& to, const Vec<3>& look_at, double fov) {
    FlightPath<3> path{"test", {}};
    for (int i = 0; i < 8; ++i) path.frames.push_back({from + (to - from) * (i / 7.0), look_at, fov});
    return path;
}

}  // namespace

Generated bottleneck(std::uint64_t seed, std::size_t) {
    Random random(seed);
    Model m;
    constexpr double height = 4;
    m.box({0, 0, -0.1}, {16, 16, 0}, top_side);
    for (const bool right : {false, true}) {
        const double x0 = right ? 8.95 : 0.05, x1 = right ? 15.95 : 7.05;
        block(m, {x0, 4.3, 0}, {x1, 7.75, height}, 6, 4, 3);
        crates(m, random, {x0 + 0.1, 4.4}, {x1 - 0.1, 7.65}, 0.85, 4);
        // Behind the block and hidden by it.
        const double middle = right ? 12.8 : 3.2;
        crates(m, random, {middle - 1.7, 11.8}, {middle + 1.7, 15.3}, 1.7, 2);
    }
    // Beyond the gap a house, whose front can be seen; behind the viewer a bench.
    block(m, {5.75, 12.45, 0}, {10.25, 15.95, height}, 7, 1, 4);
    m.box({4.4, 0.1, 0}, {5.6, 0.5, 0.45}, standing);

    Generated made;
    made.triangles = std::move(m.triangles);
    made.paths.push_back(sideways({4.5, 1.6, 1.6}, {11.5, 1.6, 1.6}, {8, 8, 1.6}, 60));
    return made;
}

Generated wall2(std::uint64_t seed, std::size_t) {
    Random random(seed);
    Model m;
    constexpr double height = 9;
    m.box({0, 0, -0.1}, {40, 40, 0}, top_side);
    m.polygon({{3, 14, 0}, {37, 14, 0}, {37, 14, height}, {3, 14, height}});
    crates(m, random, {2, 18}, {38, 38}, 2.2, 2);
    // What can be seen: a bench, lamps, trees beside the ends of the wall.
    m.box({16.5, 9, 0.35}, {18.5, 9.5, 0.45});
    for (const double x : {16.7, 18.1}) m.box({x, 9.05, 0}, {x + 0.2, 9.45, 0.35}, all_sides & ~unsigned{top_side});
    for (const double x : {8.0, 14.0, 26.0, 32.0}) {
        const Inside place(m, {x, 12.5, 0});
        street_lamp(m);
    }
    for (const double x : {1.6, 38.4})
        for (const double y : {5.0, 8.5, 12.0}) {
            const Inside place(m, {x, y, 0}, random.uniform(0, 360));
            garden_tree(m, random);
        }

    Generated made;
    made.triangles = std::move(m.triangles);
    made.paths.push_back(sideways({14, 3, 1.7}, {26, 3, 1.7}, {20, 14, 2.6}, 60));
    return made;
}

}  // namespace sightline::generate
