// The leaves of the tree as cells. Neighbours are found by walking down both sides of each interior face at once, so
// that small and large leaves meet in one pass and both directions come out together (TVCG fig. 9 needs two passes).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "core/space/builders.h"

namespace sightline {

namespace {

template <int D>
class Linker {
public:
    explicit Linker(CellComplex<D>& cells) : cells_(cells), tree_(cells.tree), rows_(tree_.leaves.size()) {}

    void link() {
        inside(0);
        for (int axis = 0; axis < D; ++axis)
            for (int side = 0; side < 2; ++side) border(0, axis, side);
        for (const auto& row : rows_) {
            cells_.half_facets.insert(cells_.half_facets.end(), row.begin(), row.end());
            cells_.cell_facet_begin.push_back(static_cast<std::uint32_t>(cells_.half_facets.size()));
        }
    }

    std::uint32_t point(const Vec<D>& p) {
        std::array<double, D> key;
        for (int i = 0; i < D; ++i) key[static_cast<std::size_t>(i)] = p[i];
        const auto [found, is_new] = point_of_.emplace(key, static_cast<std::uint32_t>(cells_.points.size()));
        if (is_new) cells_.points.push_back(p);
        return found->second;
    }

private:
    std::uint32_t child(std::uint32_t node, int index) const {
        return tree_.nodes[node].first_child + static_cast<std::uint32_t>(index);
    }
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].first_child == none; }

    void inside(std::uint32_t node) {
        if (is_leaf(node)) return;
        for (int c = 0; c < Tree<D>::child_count; ++c) inside(child(node, c));
        for (int axis = 0; axis < D; ++axis)
            for (int c = 0; c < Tree<D>::child_count; ++c)
                if (!(c >> axis & 1)) between(child(node, c), child(node, c | 1 << axis), axis);
    }

    /// Links the leaves below `low` and `high`, which share a face or a part of one perpendicular to the axis.
    void between(std::uint32_t low, std::uint32_t high, int axis) {
        if (is_leaf(low) && is_leaf(high)) {
            // The facet is the face of the smaller leaf.
            const bool low_is_small = tree_.nodes[low].box.extent().x <= tree_.nodes[high].box.extent().x;
            const std::uint32_t facet =
                add_facet(low_is_small ? tree_.nodes[low].box : tree_.nodes[high].box, axis, low_is_small);
            const std::uint32_t a = tree_.nodes[low].leaf, b = tree_.nodes[high].leaf;
            rows_[a].push_back({b, facet * 2});
            rows_[b].push_back({a, facet * 2 + 1});
            return;
        }
        for (int c = 0; c < Tree<D>::child_count; ++c) {
            if (c >> axis & 1) continue;
            // Children of `low` that touch `high` have the axis' bit set, those of `high` do not.
            const std::uint32_t l = is_leaf(low) ? low : child(low, c | 1 << axis);
            const std::uint32_t h = is_leaf(high) ? high : child(high, c);
            between(l, h, axis);
        }
    }

    void border(std::uint32_t node, int axis, int side) {
        if (!is_leaf(node)) {
            for (int c = 0; c < Tree<D>::child_count; ++c)
                if ((c >> axis & 1) == side) border(child(node, c), axis, side);
            return;
        }
        const std::uint32_t facet = add_facet(tree_.nodes[node].box, axis, side == 1);
        rows_[tree_.nodes[node].leaf].push_back({none, facet * 2 + (side == 1 ? 0u : 1u)});
    }

    /// The upper or lower face of the box; its points are ordered so that the cell below it is the unflipped side.
    std::uint32_t add_facet(const Box<D>& box, int axis, bool upper) {
        const std::uint32_t facet = facet_count_++;
        Vec<D> p = box.min;
        p[axis] = upper ? box.max[axis] : box.min[axis];
        const auto add = [&](const Vec<D>& q) { cells_.facet_points.push_back(point(q)); };
        if constexpr (D == 2) {
            Vec<2> q = p;
            q[1 - axis] = box.max[1 - axis];
            if (axis == 0) {
                add(p), add(q);
            } else {
                add(q), add(p);
            }
        } else {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto corner = [&](bool at_u, bool at_v) {
                Vec<3> q = p;
                if (at_u) q[u] = box.max[u];
                if (at_v) q[v] = box.max[v];
                return q;
            };
            add(corner(false, false)), add(corner(false, true)), add(corner(true, true)), add(corner(true, false));
        }
        return facet;
    }

    CellComplex<D>& cells_;
    const Tree<D>& tree_;
    std::vector<std::vector<HalfFacet>> rows_;
    std::uint32_t facet_count_ = 0;
    std::map<std::array<double, D>, std::uint32_t> point_of_;
};

}  // namespace

template <int D>
CellComplex<D> tree_cells(Tree<D> tree) {
    CellComplex<D> cells;
    cells.kind = Tessellation::tree;
    cells.cell_facet_begin = {0};
    cells.tree = std::move(tree);
    Linker<D> linker(cells);
    linker.link();
    for (std::uint32_t leaf = 0; leaf < cells.tree.leaves.size(); ++leaf) {
        const Box<D>& box = cells.tree.nodes[cells.tree.leaves[leaf]].box;
        cells.leaf_cell.push_back(leaf);
        for (int c = 0; c < Tree<D>::child_count; ++c) cells.cell_points.push_back(linker.point(box.corner(c)));
    }
    set_border_cells(cells);
    return cells;
}

template CellComplex<2> tree_cells<2>(Tree<2>);
template CellComplex<3> tree_cells<3>(Tree<3>);

}  // namespace sightline
