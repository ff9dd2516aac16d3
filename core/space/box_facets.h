// Facets between boxes, while a cell complex of boxes is made: the leaves of a quadtree, an octree or a kd-tree.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <map>

#include "core/space/builders.h"
#include "core/space/cell_complex.h"

namespace sightline {

template <int D>
class BoxFacets {
public:
    /// The complex has its tree and nothing else yet.
    explicit BoxFacets(CellComplex<D>& cells) : cells_(cells), rows_(cells.tree.leaves.size()) {}

    /// The upper or lower face of the box; its points are ordered so that the cell below it is the unflipped side.
    std::uint32_t add(const Box<D>& box, int axis, bool upper) {
        Vec<D> p = box.min;
        p[axis] = upper ? box.max[axis] : box.min[axis];
        if constexpr (D == 2) {
            Vec<2> q = p;
            q[1 - axis] = box.max[1 - axis];
            return axis == 0 ? add_polygon({p, q}) : add_polygon({q, p});
        } else {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto corner = [&](bool at_u, bool at_v) {
                Vec<3> q = p;
                if (at_u) q[u] = box.max[u];
                if (at_v) q[v] = box.max[v];
                return q;
            };
            return add_polygon({corner(false, false), corner(false, true), corner(true, true), corner(true, false)});
        }
    }
    /// An edge or a corner where two boxes touch: a facet that has lost its area.
    std::uint32_t add_contact(const Vec<D>& low, const Vec<D>& high) {
        if constexpr (D == 2)
            return add_polygon({low, high});
        else
            return add_polygon({low, high, high, low});
    }

    /// The facet lies between two cells; `low` sees its unflipped side.
    void link(std::uint32_t low, std::uint32_t high, std::uint32_t facet) {
        rows_[low].push_back({high, facet * 2});
        rows_[high].push_back({low, facet * 2 + 1});
    }
    /// The facet lies at the border.
    void end(std::uint32_t cell, std::uint32_t facet, bool flipped) {
        rows_[cell].push_back({none, facet * 2 + (flipped ? 1u : 0u)});
    }

    /// Puts all into the complex, with the leaves as cells.
    void finish() {
        cells_.cell_facet_begin = {0};
        for (const auto& row : rows_) {
            cells_.half_facets.insert(cells_.half_facets.end(), row.begin(), row.end());
            cells_.cell_facet_begin.push_back(static_cast<std::uint32_t>(cells_.half_facets.size()));
        }
        for (std::uint32_t leaf = 0; leaf < rows_.size(); ++leaf) {
            const Box<D>& box = cells_.tree.nodes[cells_.tree.leaves[leaf]].box;
            cells_.leaf_cell.push_back(leaf);
            for (int c = 0; c < 1 << D; ++c) cells_.cell_points.push_back(point(box.corner(c)));
        }
    }

private:
    std::uint32_t add_polygon(std::initializer_list<Vec<D>> polygon) {
        for (const Vec<D>& p : polygon) cells_.facet_points.push_back(point(p));
        return facet_count_++;
    }
    std::uint32_t point(const Vec<D>& p) {
        std::array<double, D> key;
        for (int i = 0; i < D; ++i) key[static_cast<std::size_t>(i)] = p[i];
        const auto [found, is_new] = point_of_.emplace(key, static_cast<std::uint32_t>(cells_.points.size()));
        if (is_new) cells_.points.push_back(p);
        return found->second;
    }

    CellComplex<D>& cells_;
    std::vector<std::vector<HalfFacet>> rows_;
    std::uint32_t facet_count_ = 0;
    std::map<std::array<double, D>, std::uint32_t> point_of_;
};

/// Links the leaves that share an edge or a corner and no facet, in the order of their numbers.
template <int D>
void link_touching(const Tree<D>& tree, BoxFacets<D>& facets);
extern template void link_touching<2>(const Tree<2>&, BoxFacets<2>&);
extern template void link_touching<3>(const Tree<3>&, BoxFacets<3>&);

/// The leaves of the tree as cells; `link(tree, facets)` gives them the facets that they share.
template <int D, typename Link>
CellComplex<D> box_cells(Tessellation kind, Tree<D> tree, Neighbours neighbours, Link link) {
    CellComplex<D> cells;
    cells.kind = kind;
    cells.tree = std::move(tree);
    BoxFacets<D> facets(cells);
    link(cells.tree, facets);
    if (neighbours == Neighbours::touching) link_touching(cells.tree, facets);
    facets.finish();
    set_border_cells(cells);
    return cells;
}

}  // namespace sightline
