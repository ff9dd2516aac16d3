// What must hold for the cells of any tessellation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/space/builders.h"

namespace sightline::test {

/// Exact.
template <int D>
bool holds(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& p) {
    for (const HalfFacet& half : cells.facets_of(cell))
        if (facet_side(cells, half, p) < 0) return false;
    return true;
}

template <int D>
std::uint32_t lowest_holding(const CellComplex<D>& cells, const Vec<D>& p) {
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        if (holds(cells, cell, p)) return cell;
    return none;
}

/// Neighbours know each other, with opposite sides of one facet, and lie on those sides of it. sliver(cells, cell):
/// cells whose rounded centre may lie outside them.
template <int D, typename Sliver>
void expect_linked(const CellComplex<D>& cells, Sliver sliver) {
    std::vector<std::uint32_t> border;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            const bool contact = cells.is_contact(half.facet());  // on no side of anything
            if (contact) {
                ASSERT_NE(half.neighbour, none);
            }
            if (!contact && !sliver(cells, cell)) {
                ASSERT_GT(facet_side(cells, half, cells.centre(cell)), 0);
            }
            if (half.neighbour == none) {
                if (border.empty() || border.back() != cell) border.push_back(cell);
                continue;
            }
            if (!contact && !sliver(cells, half.neighbour)) {
                ASSERT_LT(facet_side(cells, half, cells.centre(half.neighbour)), 0);
            }
            int back = 0;
            for (const HalfFacet& other : cells.facets_of(half.neighbour))
                back += other.neighbour == cell && other.facet() == half.facet() && other.flipped() != half.flipped();
            ASSERT_EQ(back, 1);
        }
    ASSERT_EQ(cells.border_cells, border);
}

/// What two boxes of leaves have in common, and how many of its sides have no length; nothing when they do not touch.
template <int D>
std::optional<std::pair<Box<D>, int>> shared_by(const CellComplex<D>& cells, std::uint32_t a, std::uint32_t b) {
    const Box<D>&of_a = cells.tree.nodes[cells.tree.leaves[a]].box, &of_b = cells.tree.nodes[cells.tree.leaves[b]].box;
    const Box<D> shared{glm::max(of_a.min, of_b.min), glm::min(of_a.max, of_b.max)};
    int flat = 0;
    for (int i = 0; i < D; ++i) {
        if (shared.min[i] > shared.max[i]) return std::nullopt;
        flat += shared.min[i] == shared.max[i];
    }
    return std::pair{shared, flat};
}

/// The neighbours of boxes, found by comparing all with all: those that share a facet, each with that facet, and with
/// neighbours=touching those that share an edge or a corner.
template <int D>
void expect_neighbours_of_boxes(const CellComplex<D>& cells, Neighbours neighbours) {
    for (std::uint32_t a = 0; a < cells.cell_count(); ++a) {
        std::vector<std::uint32_t> expected, found;
        for (std::uint32_t b = 0; b < cells.cell_count(); ++b)
            if (const auto shared = shared_by(cells, a, b);
                b != a && shared && (shared->second == 1 || neighbours == Neighbours::touching))
                expected.push_back(b);
        for (const HalfFacet& half : cells.facets_of(a)) {
            if (half.neighbour == none) continue;
            found.push_back(half.neighbour);
            const auto [shared, flat] = shared_by(cells, a, half.neighbour).value();
            ASSERT_EQ(cells.is_contact(half.facet()), flat > 1);
            Box<D> polygon;
            for (const std::uint32_t p : cells.points_of_facet(half.facet())) polygon.add(cells.points[p]);
            ASSERT_EQ(polygon.min, shared.min);
            ASSERT_EQ(polygon.max, shared.max);
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << "cell " << a;
    }
}

/// A kd-tree splits where its rule says, and no more: `count` middles lie in each leaf.
template <int D>
void expect_kd_rule(const std::vector<Primitive<D>>& primitives, double bound, std::uint32_t capacity) {
    const Tree<D> tree = build_kd_tree<D>(primitives, bound, capacity);
    const double limit = bounds<D>(primitives).longest_side() * bound;
    std::vector<std::vector<Vec<D>>> held(tree.nodes.size());
    for (const Primitive<D>& primitive : primitives) {
        Vec<D> middle(0);
        for (const Vec<D>& corner : primitive) {
            ASSERT_TRUE(tree.root_box().contains(corner));
            middle += corner;
        }
        held[0].push_back(middle / static_cast<double>(primitive.size()));
    }
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {  // children stand behind their parents
        const Vec<D> extent = tree.nodes[node].box.extent();
        const double longest = tree.nodes[node].box.longest_side();
        const std::uint32_t child = tree.nodes[node].first_child;
        if (child == none) {
            ASSERT_TRUE(held[node].size() <= capacity || longest < limit);
            for (const Vec<D>& middle : held[node]) ASSERT_EQ(tree.leaf_at(middle), tree.nodes[node].leaf);
            continue;
        }
        ASSERT_GT(held[node].size(), capacity);
        ASSERT_GE(longest, limit);
        int axis = 0;
        while (extent[axis] < longest) ++axis;
        const double plane = tree.nodes[child].box.max[axis];
        ASSERT_TRUE(tree.splits(node, axis));
        for (const Vec<D>& middle : held[node]) held[child + (middle[axis] >= plane)].push_back(middle);
        // At most half lie on either side, those on the plane aside; or the plane is in the middle.
        const auto on = static_cast<std::size_t>(
            std::count_if(held[node].begin(), held[node].end(), [&](const Vec<D>& m) { return m[axis] == plane; }));
        const std::size_t half = (held[node].size() + 1) / 2;
        if (plane != tree.nodes[node].box.min[axis] + extent[axis] / 2) {
            ASSERT_LE(held[child].size(), half);
            ASSERT_LE(held[child + 1].size() - on, half);
        }
    }
}

}  // namespace sightline::test
