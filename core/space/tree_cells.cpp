// The leaves of the tree as cells. Neighbours are found by walking down both sides of each interior face at once, so
// that small and large leaves meet in one pass and both directions come out together (TVCG fig. 9 needs two passes).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_facets.h"
#include "core/space/builders.h"

namespace sightline {

namespace {

template <int D>
class Linker {
public:
    Linker(const Tree<D>& tree, BoxFacets<D>& facets) : tree_(tree), facets_(facets) {}

    void link() {
        inside(0);
        for (int axis = 0; axis < D; ++axis)
            for (int side = 0; side < 2; ++side) border(0, axis, side);
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
            facets_.link(tree_.nodes[low].leaf, tree_.nodes[high].leaf,
                         facets_.add(tree_.nodes[low_is_small ? low : high].box, axis, low_is_small));
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
        if (is_leaf(node)) {
            facets_.end(tree_.nodes[node].leaf, facets_.add(tree_.nodes[node].box, axis, side == 1), side == 0);
            return;
        }
        for (int c = 0; c < Tree<D>::child_count; ++c)
            if ((c >> axis & 1) == side) border(child(node, c), axis, side);
    }

    const Tree<D>& tree_;
    BoxFacets<D>& facets_;
};

}  // namespace

template <int D>
CellComplex<D> tree_cells(Tree<D> tree, Neighbours neighbours) {
    tree.empty_leaves = {};
    return box_cells(Tessellation::tree, std::move(tree), neighbours,
                     [](const Tree<D>& made, BoxFacets<D>& facets) { Linker<D>(made, facets).link(); });
}

template CellComplex<2> tree_cells<2>(Tree<2>, Neighbours);
template CellComplex<3> tree_cells<3>(Tree<3>, Neighbours);

}  // namespace sightline
