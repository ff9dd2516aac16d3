// The leaves of the kd-tree as cells. A facet is what the faces of two leaves have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_facets.h"
#include "core/space/builders.h"

namespace sightline {

namespace {

template <int D>
class KdLinker {
public:
    KdLinker(const Tree<D>& tree, BoxFacets<D>& facets) : tree_(tree), facets_(facets) {}

    void link() {
        inside(0);
        for (int axis = 0; axis < D; ++axis)
            for (const bool upper : {false, true}) border(0, axis, upper);
    }

private:
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].first_child == none; }

    void inside(std::uint32_t node) {
        if (is_leaf(node)) return;
        const std::uint32_t first = tree_.nodes[node].first_child;
        inside(first);
        inside(first + 1);
        for (int axis = 0; axis < D; ++axis)
            if (tree_.splits(node, axis)) between(first, first + 1, axis);
    }

    /// Links the leaves below `low` and `high`, which share a part of a plane across the axis.
    void between(std::uint32_t low, std::uint32_t high, int axis) {
        const Box<D>&a = tree_.nodes[low].box, &b = tree_.nodes[high].box;
        Box<D> shared{glm::max(a.min, b.min), glm::min(a.max, b.max)};
        for (int i = 0; i < D; ++i)
            if (i != axis && !(shared.min[i] < shared.max[i])) return;
        if (is_leaf(low) && is_leaf(high)) {
            shared.min[axis] = shared.max[axis] = a.max[axis];
            facets_.link(tree_.nodes[low].leaf, tree_.nodes[high].leaf, facets_.add(shared, axis, true));
            return;
        }
        const bool opens_low = !is_leaf(low);
        const std::uint32_t opened = opens_low ? low : high, first = tree_.nodes[opened].first_child;
        for (const std::uint32_t upper : {0u, 1u}) {
            if (tree_.splits(opened, axis) && (upper == 1) != opens_low) continue;  // away from the plane
            opens_low ? between(first + upper, high, axis) : between(low, first + upper, axis);
        }
    }

    void border(std::uint32_t node, int axis, bool upper) {
        if (is_leaf(node)) {
            facets_.end(tree_.nodes[node].leaf, facets_.add(tree_.nodes[node].box, axis, upper), !upper);
            return;
        }
        for (const std::uint32_t child : {0u, 1u})
            if (!tree_.splits(node, axis) || (child == 1) == upper)
                border(tree_.nodes[node].first_child + child, axis, upper);
    }

    const Tree<D>& tree_;
    BoxFacets<D>& facets_;
};

}  // namespace

template <int D>
CellComplex<D> kd_cells(Tree<D> tree, Neighbours neighbours) {
    return box_cells(Tessellation::kd, std::move(tree), neighbours,
                     [](const Tree<D>& made, BoxFacets<D>& facets) { KdLinker<D>(made, facets).link(); });
}

template CellComplex<2> kd_cells<2>(Tree<2>, Neighbours);
template CellComplex<3> kd_cells<3>(Tree<3>, Neighbours);

}  // namespace sightline
