// Random tessellations in 3D: leaves of octrees, and tetrahedra.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
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

inline CellComplex<3> random_cells(Random& random) {
    Tree<3> tree = build_tree<3>(random_triangles(random, random.below(30)), random.uniform(0.1, 0.6));
    return random.below(2) == 0 ? delaunay_cells(std::move(tree), Settings{}) : tree_cells(std::move(tree));
}

}  // namespace sightline::test
