// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/scene/make/generators_failures.h"
#include "core/scene/make/model.h"

namespace sightline::failures {

namespace {

Generated made(Model&& model) {
    Generated result;
    result.two_sided.assign(model.triangles.size(), 1);
    result.triangles = std::move(model.triangles);
    return result;
}

}  // namespace

Generated raise(const std::vector<Primitive<2>>& plan, double height) {
    Model m;
    for (const auto& [a, b] : plan) m.polygon({{a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, height}, {a.x, a.y, height}});
    return made(std::move(m));
}

Generated needles_3d(std::uint64_t seed, std::size_t) {
    Random random(seed);
    Model m;
    // A fan: 3000 needles from 2 m up to the floor.
    for (int i = 0; i < 3000; ++i)
        m.triangle({5, 10, 2}, {2 + i / 500.0, 10, 0}, {2 + (i + random.uniform(0.3, 1)) / 500.0, 10, 0});
    // A board whose two halves are cut at different heights: thirds below, sevenths above, no corner shared.
    for (int column = 0; column < 20; ++column) {
        const double x = 9 + 0.3 * column, end = 9 + 0.3 * (column + 1);
        const int cuts = column % 2 == 0 ? 3 : 7;
        for (int i = 0; i < cuts; ++i)
            m.polygon({{x, 10, 2.0 * i / cuts},
                       {end, 10, 2.0 * i / cuts},
                       {end, 10, 2.0 * (i + 1) / cuts},
                       {x, 10, 2.0 * (i + 1) / cuts}});
    }
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 32; ++column) {
            const double x = 0.5 * column, z = 0.3 * row;
            m.polygon({{x, 13, z}, {x + 0.5, 13, z}, {x + 0.5, 13, z + 0.3}, {x, 13, z + 0.3}});
        }
    return made(std::move(m));
}

Generated lattice_3d(std::uint64_t, std::size_t) {
    Model m;
    for (int z = 0; z < 16; ++z)
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const Vec<3> c(x + 0.5, y + 0.5, z + 0.5);
                m.triangle(c + Vec<3>(-0.125, 0, -0.125), c + Vec<3>(0.125, 0, -0.125), c + Vec<3>(0, 0, 0.125));
            }
    m.triangle({0, 0, 0}, {0.25, 0, 0}, {0, 0, 0.25});
    m.triangle({16, 16, 16}, {15.75, 16, 16}, {16, 16, 15.75});
    return made(std::move(m));
}

Generated valley(std::uint64_t seed, std::size_t) {
    Random random(seed);
    Model m;
    constexpr int size = 64;
    std::vector<double> height((size + 1) * (size + 1));
    const auto at = [&](int x, int y) -> double& { return height[static_cast<std::size_t>(y * (size + 1) + x)]; };
    for (int y = 0; y <= size; ++y)
        for (int x = 0; x <= size; ++x) {
            const double u = x - size / 2.0, v = y - size / 2.0;
            at(x, y) = 0.012 * (u * u + v * v) + 0.8 * sincos_degrees(17.0 * x).sin * sincos_degrees(23.0 * y).sin +
                       random.uniform(0, 0.15);
        }
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto corner = [&](int i, int j) { return Vec<3>(2.0 * i, 2.0 * j, at(i, j)); };
            m.triangle(corner(x, y), corner(x + 1, y), corner(x + 1, y + 1));
            m.triangle(corner(x, y), corner(x + 1, y + 1), corner(x, y + 1));
        }
    Generated result;
    result.triangles = std::move(m.triangles);
    return result;
}

}  // namespace sightline::failures
