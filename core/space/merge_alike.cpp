// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/merge_alike.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/clip.h"

namespace sightline {

namespace {

template <int D>
class Merger {
public:
    Merger(const Tree<D>& tree, const std::vector<Primitive<D>>& primitives, double tolerance)
        : tree_(tree), tolerance_(tolerance), held_(tree.nodes.size()), whole_(tree.nodes.size()) {
        for (const Primitive<D>& primitive : primitives) {
            Box<D> box;
            for (const Vec<D>& corner : primitive) box.add(corner);
            add(0, primitive, box);
        }
        judge(0);
    }

    Tree<D> take() {
        made_.nodes.push_back({tree_.root_box()});
        copy_below(0, 0);
        return std::move(made_);
    }

private:
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].first_child == none; }

    std::uint32_t child_count(std::uint32_t node) const {
        std::uint32_t count = 1;
        for (int i = 0; i < D; ++i) count <<= tree_.splits(node, i);
        return count;
    }

    /// Gives the primitive to the leaves that it reaches.
    void add(std::uint32_t node, const Primitive<D>& primitive, const Box<D>& box) {
        const Box<D>& here = tree_.nodes[node].box;
        for (int i = 0; i < D; ++i)
            if (box.max[i] < here.min[i] || box.min[i] > here.max[i]) return;
        if (is_leaf(node)) {
            held_[node] += size_inside(HalfSpaces<D>(here), primitive);
            return;
        }
        const std::uint32_t first = tree_.nodes[node].first_child;
        for (std::uint32_t child = first; child < first + child_count(node); ++child) add(child, primitive, box);
    }

    /// Opacity of a part that holds so much, over a way.
    double opacity(std::uint32_t node, double way) const {
        const ConvexSize size = size_of(tree_.nodes[node].box);
        const double chord = size.template mean_chord<D>();
        const double depth = chord > 0 ? size.depth_of(held_[node]) * (way / chord) : 0;
        return std::isfinite(depth) ? depth / (1 + depth) : 1;
    }

    void judge(std::uint32_t node) {
        whole_[node] = true;
        if (is_leaf(node)) return;
        const std::uint32_t first = tree_.nodes[node].first_child, end = first + child_count(node);
        for (std::uint32_t child = first; child < end; ++child) {
            judge(child);
            held_[node] += held_[child];
            whole_[node] = whole_[node] && whole_[child];
        }
        const double way = size_of(tree_.nodes[node].box).template mean_chord<D>(), own = opacity(node, way);
        for (std::uint32_t child = first; child < end; ++child)
            whole_[node] = whole_[node] && std::abs(opacity(child, way) - own) <= tolerance_;
    }

    bool is_empty(std::uint32_t node) const {
        if (is_leaf(node))
            return std::binary_search(tree_.empty_leaves.begin(), tree_.empty_leaves.end(), tree_.nodes[node].leaf);
        const std::uint32_t first = tree_.nodes[node].first_child;
        for (std::uint32_t child = first; child < first + child_count(node); ++child)
            if (!is_empty(child)) return false;
        return true;
    }

    void copy_below(std::uint32_t from, std::uint32_t to) {
        if (whole_[from]) {
            made_.nodes[to].leaf = static_cast<std::uint32_t>(made_.leaves.size());
            if (is_empty(from)) made_.empty_leaves.push_back(made_.nodes[to].leaf);
            made_.leaves.push_back(to);
            return;
        }
        const std::uint32_t children = tree_.nodes[from].first_child, count = child_count(from);
        const auto first_child = static_cast<std::uint32_t>(made_.nodes.size());
        made_.nodes[to].first_child = first_child;
        for (std::uint32_t child = 0; child < count; ++child)
            made_.nodes.push_back({tree_.nodes[children + child].box});
        for (std::uint32_t child = 0; child < count; ++child) copy_below(children + child, first_child + child);
    }

    const Tree<D>& tree_;
    double tolerance_;
    std::vector<double> held_;         ///< per node: area, 2D length, of the primitives inside
    std::vector<std::uint8_t> whole_;  ///< per node: 1 where it becomes or stays a leaf
    Tree<D> made_;
};

}  // namespace

template <int D>
Tree<D> merge_alike(const Tree<D>& tree, const std::vector<Primitive<D>>& primitives, double tolerance) {
    return Merger<D>(tree, primitives, tolerance).take();
}

template Tree<2> merge_alike<2>(const Tree<2>&, const std::vector<Primitive<2>>&, double);
template Tree<3> merge_alike<3>(const Tree<3>&, const std::vector<Primitive<3>>&, double);

}  // namespace sightline
