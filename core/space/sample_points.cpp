// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/sample_points.h"

#include "core/base/random.h"

namespace sightline {

namespace {

/// How far the border's box reaches beyond the tree's root, in its sides. Any positive share closes the hull gap
/// (docs/algorithm.md); a small one keeps the border's cells from being slivers.
constexpr double border_share = 0.05;

/// The centres that are left: of each leaf by its number, before any jitter; those that are left out are marked.
template <int D>
struct LeafCentres {
    std::vector<Vec<D>> at;
    std::vector<std::uint8_t> left_out;
};

template <int D>
LeafCentres<D> leaf_centres(const Tree<D>& tree, EmptyLeaves empty_leaves) {
    LeafCentres<D> centres{{}, std::vector<std::uint8_t>(tree.leaves.size())};
    for (const std::uint32_t node : tree.leaves) centres.at.push_back(tree.nodes[node].box.centre());
    if (empty_leaves == EmptyLeaves::keep) return centres;
    for (const std::uint32_t leaf : tree.empty_leaves) centres.left_out[leaf] = 1;
    if (empty_leaves == EmptyLeaves::drop) return centres;
    // The first empty leaf of each node stands for all of them, in their middle.
    for (const auto& node : tree.nodes) {
        if (node.first_child == none) continue;
        std::uint32_t first = none;
        Vec<D> sum(0);
        double count = 0;
        for (std::uint32_t child = node.first_child; child < node.first_child + Tree<D>::child_count; ++child) {
            const std::uint32_t leaf = tree.nodes[child].leaf;
            if (leaf == none || !centres.left_out[leaf]) continue;
            if (first == none) first = leaf;
            sum += centres.at[leaf];
            ++count;
        }
        if (first == none) continue;
        centres.at[first] = sum / count;
        centres.left_out[first] = 0;
    }
    return centres;
}

}  // namespace

template <int D>
std::vector<Vec<D>> sample_points(const Tree<D>& tree, const TessellationSettings& settings) {
    std::vector<Vec<D>> points;
    points.reserve(tree.leaves.size() + Tree<D>::child_count);
    Random random(settings.seed);
    const LeafCentres<D> centres = leaf_centres(tree, settings.empty_leaves);
    for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        const Box<D>& box = tree.nodes[tree.leaves[leaf]].box;
        const double reach = settings.jitter * (box.max.x - box.min.x);
        Vec<D> offset;
        for (int i = 0; i < D; ++i) offset[i] = random.uniform(-reach, reach);
        if (!centres.left_out[leaf]) points.push_back(centres.at[leaf] + offset);
    }
    if (settings.border == Border::inflated) {
        const Box<D>& root = tree.root_box();
        const Vec<D> margin(border_share * (root.max.x - root.min.x));
        const Box<D> border{root.min - margin, root.max + margin};
        for (int corner = 0; corner < Tree<D>::child_count; ++corner) points.push_back(border.corner(corner));
    }
    return points;
}

template <int D>
void set_leaf_cells(CellComplex<D>& cells, const Tree<D>& tree, const TessellationSettings& settings) {
    std::vector<std::uint32_t> cell_at(cells.points.size(), 0);
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const std::uint32_t corner : cells.corners_of(cell)) cell_at[corner] = cell;
    const std::vector<std::uint8_t> left_out = leaf_centres(tree, settings.empty_leaves).left_out;
    std::uint32_t point = 0;
    for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        const bool has_point = !left_out[leaf];
        cells.leaf_cell.push_back(has_point ? cell_at[point] : leaf > 0 ? cells.leaf_cell.back() : 0);
        point += has_point;
    }
}

template std::vector<Vec<2>> sample_points<2>(const Tree<2>&, const TessellationSettings&);
template std::vector<Vec<3>> sample_points<3>(const Tree<3>&, const TessellationSettings&);
template void set_leaf_cells<2>(CellComplex<2>&, const Tree<2>&, const TessellationSettings&);
template void set_leaf_cells<3>(CellComplex<3>&, const Tree<3>&, const TessellationSettings&);

}  // namespace sightline
