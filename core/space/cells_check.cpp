// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cells_check.h"

#include <algorithm>

namespace sightline {

namespace {

using Indices = std::vector<std::uint32_t>;

bool below(const Indices& indices, std::size_t limit) {
    return std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < limit; });
}

bool are_rows(const Indices& begin, std::size_t rows, std::size_t size) {
    return begin.size() == rows + 1 && begin.front() == 0 && begin.back() == size &&
           std::is_sorted(begin.begin(), begin.end());
}

/// Whether the node's box is cut into those of its children, as build_tree() or build_kd_tree() does.
template <int D>
bool is_cut(const Tree<D>& tree, std::uint32_t node, bool kd) {
    const Box<D>& box = tree.nodes[node].box;
    const std::uint32_t first = tree.nodes[node].first_child;
    Vec<D> plane = box.centre();
    std::uint32_t children = Tree<D>::child_count;
    int split = -1;
    if (kd) {
        children = 2;
        plane = tree.nodes[first].box.max;
        for (int i = 0; i < D; ++i)
            if (tree.splits(node, i)) split = i;
        if (split < 0 || !(box.min[split] < plane[split])) return false;
    }
    for (std::uint32_t child = 0; child < children; ++child) {
        Box<D> part = box;
        for (int i = 0; i < D; ++i)
            if (!kd)
                (child >> i & 1 ? part.min : part.max)[i] = plane[i];
            else if (i == split)
                (child == 1 ? part.min : part.max)[i] = plane[i];
        if (tree.nodes[first + child].box.min != part.min || tree.nodes[first + child].box.max != part.max)
            return false;
    }
    return true;
}

template <int D>
bool is_tree(const Tree<D>& tree, bool kd) {
    const std::uint32_t children = kd ? 2 : Tree<D>::child_count;
    if (tree.nodes.empty()) return false;
    for (int i = 0; i < D; ++i)  // the boxes below are parts of the root's
        if (!(tree.root_box().min[i] < tree.root_box().max[i] && std::isfinite(tree.root_box().extent()[i])))
            return false;
    std::size_t leaves = 0, next_children = 1;
    std::vector<std::uint32_t> stack{0};  // depth first: the order of build_tree()
    while (!stack.empty()) {
        const std::uint32_t at = stack.back();
        stack.pop_back();
        const auto& node = tree.nodes[at];
        if (node.first_child == none) {
            if (node.leaf != leaves || leaves >= tree.leaves.size() || tree.leaves[leaves] != at) return false;
            ++leaves;
            continue;
        }
        if (node.leaf != none || node.first_child != next_children || next_children + children > tree.nodes.size() ||
            !is_cut(tree, at, kd))
            return false;
        for (std::uint32_t child = children; child > 0; --child) stack.push_back(node.first_child + child - 1);
        next_children += children;
    }
    return leaves == tree.leaves.size() && next_children == tree.nodes.size();
}

/// Each facet has one side that is not flipped and at most one that is, and each names the cell of the other.
template <int D>
bool are_links(const CellComplex<D>& cells) {
    struct Side {
        std::uint32_t cell = none, neighbour = none;
    };
    std::vector<Side> sides(2 * std::size_t{cells.facet_count()});
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            if (half.facet_side >= sides.size() || sides[half.facet_side].cell != none) return false;
            sides[half.facet_side] = {cell, half.neighbour};
        }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side &side = sides[i], &other = sides[i ^ 1];
        if (side.cell == none && other.cell == none) return false;
        if (side.cell != none && side.neighbour != other.cell) return false;
    }
    return true;
}

template <int D>
bool are_references(const CellComplex<D>& cells, std::size_t primitive_count) {
    if (!are_rows(cells.cell_primitive_begin, cells.cell_count(), cells.cell_primitives.size())) return false;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const auto row = cells.primitives_of(cell);
        if (!row.empty() && row.back() >= primitive_count) return false;
        if (std::adjacent_find(row.begin(), row.end(), std::greater_equal<>()) != row.end()) return false;
    }
    return true;
}

}  // namespace

template <int D>
const char* fault(const CellComplex<D>& cells, std::size_t primitive_count) {
    const bool tree_kind = cells.has_boxes();
    const std::size_t corners = tree_kind ? Tree<D>::child_count : D + 1, facet_size = D == 3 && tree_kind ? 4 : D;
    if (!std::all_of(cells.points.begin(), cells.points.end(), [](const Vec<D>& p) { return is_finite<D>(p); }))
        return "a point is not finite";
    if (cells.cell_points.size() % corners != 0 || !below(cells.cell_points, cells.points.size()))
        return "the cells' corners are wrong";
    if (cells.facet_points.size() % facet_size != 0 || !below(cells.facet_points, cells.points.size()))
        return "the facets' points are wrong";
    if (tree_kind ? !are_rows(cells.cell_facet_begin, cells.cell_count(), cells.half_facets.size())
                  : !cells.cell_facet_begin.empty() || cells.half_facets.size() != corners * cells.cell_count())
        return "the cells' facets are wrong";
    if (!are_links(cells)) return "neighbours do not agree";
    if (!is_tree(cells.tree, cells.kind == Tessellation::kd)) return "the tree is wrong";
    if (cells.leaf_cell.size() != cells.tree.leaves.size() ||
        (tree_kind && cells.cell_count() != cells.tree.leaves.size()) ||
        (cells.cell_count() > 0 && !below(cells.leaf_cell, cells.cell_count())))
        return "the cells of the leaves are wrong";
    if (!are_references(cells, primitive_count)) return "the cells' primitives are wrong";
    return nullptr;
}

template const char* fault<2>(const CellComplex<2>&, std::size_t);
template const char* fault<3>(const CellComplex<3>&, std::size_t);

}  // namespace sightline
