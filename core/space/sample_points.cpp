// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/sample_points.h"

#include "core/base/random.h"

namespace sightline {

namespace {

/// How far the border's box reaches beyond the tree's root, in its sides. Any positive share closes the hull gap
/// (docs/algorithm.md); a small one keeps the border's cells from being slivers.
constexpr double border_share = 0.05;

/// Whether a leaf's centre is left out. The leaves must be asked for in order.
template <int D>
class DroppedLeaves {
public:
    DroppedLeaves(const Tree<D>& tree, const TessellationSettings& settings)
        : next_(tree.empty_leaves.begin()),
          end_(settings.empty_leaves == EmptyLeaves::drop ? tree.empty_leaves.end() : next_) {}
    bool operator()(std::uint32_t leaf) {
        if (next_ == end_ || *next_ != leaf) return false;
        ++next_;
        return true;
    }

private:
    std::vector<std::uint32_t>::const_iterator next_, end_;
};

}  // namespace

template <int D>
std::vector<Vec<D>> sample_points(const Tree<D>& tree, const TessellationSettings& settings) {
    std::vector<Vec<D>> points;
    points.reserve(tree.leaves.size() + Tree<D>::child_count);
    Random random(settings.seed);
    DroppedLeaves<D> dropped(tree, settings);
    for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        const Box<D>& box = tree.nodes[tree.leaves[leaf]].box;
        const double reach = settings.jitter * (box.max.x - box.min.x);
        Vec<D> offset;
        for (int i = 0; i < D; ++i) offset[i] = random.uniform(-reach, reach);
        if (!dropped(leaf)) points.push_back(box.centre() + offset);
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
    DroppedLeaves<D> dropped(tree, settings);
    std::uint32_t point = 0;
    for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        const bool has_point = !dropped(leaf);
        cells.leaf_cell.push_back(has_point ? cell_at[point] : leaf > 0 ? cells.leaf_cell.back() : 0);
        point += has_point;
    }
}

template std::vector<Vec<2>> sample_points<2>(const Tree<2>&, const TessellationSettings&);
template std::vector<Vec<3>> sample_points<3>(const Tree<3>&, const TessellationSettings&);
template void set_leaf_cells<2>(CellComplex<2>&, const Tree<2>&, const TessellationSettings&);
template void set_leaf_cells<3>(CellComplex<3>&, const Tree<3>&, const TessellationSettings&);

}  // namespace sightline
