// Random tessellations in 3D: leaves of octrees, and tetrahedra.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>

#include "core/geometry/random.h"
#include "core/space/builders.h"

namespace sightline::test {

inline std::vector<Primitive<3>> random_triangles(Random& random, std::size_t count) {
    std::vector<Primitive<3>> triangles(count);
    for (Primitive<3>& t : triangles) {
        t[0] = {random.unit(), random.unit(), random.unit()};
        for (int k : {1, 2})
            t[static_cast<std::size_t>(k)] =
                t[0] + Vec<3>(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
    }
    return triangles;
}

/// The unit cube cut into side^3 cubes and each of these into six tetrahedra about a diagonal (Kuhn).
inline CellComplex<3> tetrahedra(int side) {
    CellComplex<3> cells;
    const auto point = [&](int x, int y, int z) {
        return static_cast<std::uint32_t>((z * (side + 1) + y) * (side + 1) + x);
    };
    for (int z = 0; z <= side; ++z)
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= side; ++x) cells.points.push_back(Vec<3>(x, y, z) / double(side));
    std::map<std::array<std::uint32_t, 3>, std::pair<std::uint32_t, std::uint32_t>> open;  // facet, its half's place
    const auto add = [&](std::array<std::uint32_t, 4> corners) {
        const std::uint32_t cell = cells.cell_count();
        if (orient(cells.points[corners[0]], cells.points[corners[1]], cells.points[corners[2]],
                   cells.points[corners[3]]) < 0)
            std::swap(corners[2], corners[3]);
        cells.cell_points.insert(cells.cell_points.end(), corners.begin(), corners.end());
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            std::array<std::uint32_t, 3> face;
            for (std::size_t i = 0, k = 0; i < 4; ++i)
                if (i != left_out) face[k++] = corners[i];
            // Counter-clockwise as the cell sees it from inside.
            if (orient(cells.points[face[0]], cells.points[face[1]], cells.points[face[2]],
                       cells.points[corners[left_out]]) < 0)
                std::swap(face[1], face[2]);
            std::array<std::uint32_t, 3> name = face;
            std::sort(name.begin(), name.end());
            if (const auto found = open.find(name); found != open.end()) {
                const auto [facet, other] = found->second;
                cells.half_facets[other].neighbour = cell;
                cells.half_facets.push_back({other / 4, facet * 2 + 1});
                continue;
            }
            open[name] = {cells.facet_count(), static_cast<std::uint32_t>(cells.half_facets.size())};
            cells.half_facets.push_back({none, cells.facet_count() * 2});
            cells.facet_points.insert(cells.facet_points.end(), face.begin(), face.end());
        }
    };
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                std::array<int, 3> order{0, 1, 2};  // of axes along the way from corner to corner
                do {
                    std::array<int, 3> at{x, y, z};
                    std::array<std::uint32_t, 4> corners{point(x, y, z)};
                    for (std::size_t i = 0; i < 3; ++i) {
                        ++at[static_cast<std::size_t>(order[i])];
                        corners[i + 1] = point(at[0], at[1], at[2]);
                    }
                    add(corners);
                } while (std::next_permutation(order.begin(), order.end()));
            }
    return cells;
}

inline CellComplex<3> random_cells(Random& random) {
    if (random.below(2) == 0) return tetrahedra(static_cast<int>(1 + random.below(5)));
    return tree_cells<3>(build_tree<3>(random_triangles(random, random.below(30)), random.uniform(0.1, 0.6)));
}

}  // namespace sightline::test
