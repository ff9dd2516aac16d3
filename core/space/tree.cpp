// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/tree.h"

#include <algorithm>
#include <utility>

namespace sightline {

namespace {

/// Vertices come one after the other: a leaf remembers those that differ, as many as it may hold, and splits when
/// another one comes. The nodes are put into depth-first order at the end, which does not depend on that of the
/// vertices.
template <int D>
class Builder {
public:
    Builder(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity)
        : capacity_(leaf_capacity) {
        const Box<D> box = bounds<D>(primitives);
        smallest_side_ = box.longest_side() * error_bound;
        add_node(root(box));
        for (const Primitive<D>& p : primitives)
            for (const Vec<D>& v : p) insert(v);
    }

    Tree<D> take() {
        tree_.nodes.push_back({made_[0].box});
        copy_below(0, 0);
        return std::move(tree_);
    }

private:
    struct Node : Tree<D>::Node {
        std::vector<Vec<D>> held;  ///< sorted
    };

    static Box<D> root(const Box<D>& box) {
        const double side = box.longest_side();
        if (box.empty() || side == 0) {
            const Vec<D> centre = box.empty() ? Vec<D>(0) : box.centre();
            return {centre - Vec<D>(0.5), centre + Vec<D>(0.5)};
        }
        // Rounding may leave an extreme vertex an ulp outside the cube: every vertex must lie in the root.
        return {glm::min(box.min, box.centre() - Vec<D>(side / 2)), glm::max(box.max, box.centre() + Vec<D>(side / 2))};
    }

    void add_node(const Box<D>& box) {
        Node node;
        node.box = box;
        made_.push_back(node);
    }

    bool can_split(const Box<D>& box) const {
        if (box.max.x - box.min.x < smallest_side_) return false;
        const Vec<D> middle = box.centre();
        for (int i = 0; i < D; ++i)
            if (!(box.min[i] < middle[i] && middle[i] < box.max[i])) return false;  // out of doubles
        return true;
    }

    std::uint32_t child_at(std::uint32_t node, const Vec<D>& p) const {
        const Vec<D>& middle = made_[made_[node].first_child].box.max;
        std::uint32_t child = made_[node].first_child;
        for (int i = 0; i < D; ++i) child += static_cast<std::uint32_t>(p[i] >= middle[i]) << i;
        return child;
    }

    void insert(const Vec<D>& p) {
        std::uint32_t node = 0;
        for (;;) {
            while (made_[node].first_child != none) node = child_at(node, p);
            std::vector<Vec<D>>& held = made_[node].held;
            const auto place = std::lower_bound(held.begin(), held.end(), p, comes_first);
            if (place != held.end() && *place == p) return;
            if (held.size() < capacity_) {
                held.insert(place, p);
                return;
            }
            if (!can_split(made_[node].box)) return;
            split(node);
        }
    }

    void split(std::uint32_t node) {
        const Box<D> box = made_[node].box;
        const Vec<D> middle = box.centre();
        made_[node].first_child = static_cast<std::uint32_t>(made_.size());
        for (int child = 0; child < Tree<D>::child_count; ++child) {
            Box<D> part = box;
            for (int i = 0; i < D; ++i) (child >> i & 1 ? part.min : part.max)[i] = middle[i];
            add_node(part);
        }
        for (const Vec<D>& vertex : std::exchange(made_[node].held, {}))
            made_[child_at(node, vertex)].held.push_back(vertex);
    }

    static bool comes_first(const Vec<D>& a, const Vec<D>& b) {
        for (int i = 0; i < D; ++i)
            if (a[i] != b[i]) return a[i] < b[i];
        return false;
    }

    void copy_below(std::uint32_t from, std::uint32_t to) {
        const std::uint32_t children = made_[from].first_child;
        if (children == none) {
            tree_.nodes[to].leaf = static_cast<std::uint32_t>(tree_.leaves.size());
            if (made_[from].held.empty()) tree_.empty_leaves.push_back(tree_.nodes[to].leaf);
            tree_.leaves.push_back(to);
            return;
        }
        const auto first_child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[to].first_child = first_child;
        for (std::uint32_t child = 0; child < Tree<D>::child_count; ++child)
            tree_.nodes.push_back({made_[children + child].box});
        for (std::uint32_t child = 0; child < Tree<D>::child_count; ++child)
            copy_below(children + child, first_child + child);
    }

    Tree<D> tree_;
    std::vector<Node> made_;  ///< in the order in which they came
    double smallest_side_ = 0;
    std::size_t capacity_;
};

}  // namespace

template <int D>
Tree<D> build_tree(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity) {
    return Builder<D>(primitives, error_bound, leaf_capacity).take();
}

template Tree<2> build_tree<2>(const std::vector<Primitive<2>>&, double, std::uint32_t);
template Tree<3> build_tree<3>(const std::vector<Primitive<3>>&, double, std::uint32_t);

}  // namespace sightline
