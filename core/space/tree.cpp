// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/tree.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/workers.h"

namespace sightline {

namespace {

/// Vertices come one after the other: a leaf remembers those that differ, as many as it may hold, and splits when
/// another one comes. The nodes are put into depth-first order at the end, which does not depend on that of the
/// vertices, nor on how they were shared out among builders that are then put together.
template <int D>
class Builder {
public:
    /// For primitives in the box.
    Builder(const Box<D>& box, double error_bound, std::uint32_t leaf_capacity)
        : smallest_side_(box.longest_side() * error_bound), capacity_(leaf_capacity) {
        add_node(root(box));
    }

    void add(std::span<const Primitive<D>> primitives) {
        for (const Primitive<D>& p : primitives)
            for (const Vec<D>& v : p) insert(holds(last_leaf_, v) ? last_leaf_ : 0, v);
    }
    /// What another builder for the same box was given.
    void add(const Builder& other) { add_below(0, other, 0); }

    Tree<D> take() {
        tree_.nodes.push_back({made_[0].box});
        copy_below(0, 0);
        return std::move(tree_);
    }

private:
    struct Node : Tree<D>::Node {
        std::vector<Vec<D>> held;  ///< sorted
        bool full = false;         ///< a leaf that holds what it may and cannot split
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

    void add_below(std::uint32_t node, const Builder& other, std::uint32_t there) {
        const std::uint32_t children = other.made_[there].first_child;
        if (children == none) {
            for (const Vec<D>& vertex : other.made_[there].held) insert(node, vertex);
            return;
        }
        if (made_[node].first_child == none) split(node);  // more than it may hold, for the other did
        for (std::uint32_t child = 0; child < Tree<D>::child_count; ++child)
            add_below(made_[node].first_child + child, other, children + child);
    }

    /// Whether the way down comes by that node; false too for some points on the root's upper sides.
    bool holds(std::uint32_t node, const Vec<D>& p) const {
        const Box<D>& box = made_[node].box;
        bool inside = true;
        for (int i = 0; i < D; ++i) {
            inside &= box.min[i] <= p[i];
            inside &= p[i] < box.max[i];
        }
        return inside;
    }

    /// At a node that holds it or below.
    void insert(std::uint32_t node, const Vec<D>& p) {
        for (;;) {
            while (made_[node].first_child != none) node = child_at(node, p);
            last_leaf_ = node;
            if (made_[node].full) return;
            std::vector<Vec<D>>& held = made_[node].held;
            const auto place = std::lower_bound(held.begin(), held.end(), p, comes_first);
            if (place != held.end() && *place == p) return;
            if (held.size() < capacity_) {
                held.insert(place, p);
                return;
            }
            made_[node].full = !can_split(made_[node].box);
            if (made_[node].full) return;
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
    std::vector<Node> made_;       ///< in the order in which they came
    std::uint32_t last_leaf_ = 0;  ///< vertices that follow each other lie close together more often than not
    double smallest_side_ = 0;
    std::size_t capacity_;
};

}  // namespace

template <int D>
Tree<D> build_tree(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity) {
    constexpr std::size_t few = std::size_t{1} << 15;
    const std::size_t parts = primitives.size() < few ? 1 : 4;
    const auto part = [&](std::size_t i) {
        const std::size_t begin = i * primitives.size() / parts, end = (i + 1) * primitives.size() / parts;
        return std::span(primitives).subspan(begin, end - begin);
    };
    const auto side_by_side = [&](auto use) {
        run_parts(static_cast<int>(parts), 0, [&](int i) { use(static_cast<std::size_t>(i)); });
    };
    std::vector<Box<D>> boxes(parts);
    side_by_side([&](std::size_t i) {
        for (const Primitive<D>& p : part(i))
            for (const Vec<D>& v : p) boxes[i].add(v);
    });
    for (const Box<D>& box : boxes) boxes[0].add(box);
    std::vector<Builder<D>> builders(parts, Builder<D>(boxes[0], error_bound, leaf_capacity));
    side_by_side([&](std::size_t i) { builders[i].add(part(i)); });
    for (std::size_t i = 1; i < parts; ++i) builders[0].add(builders[i]);
    return builders[0].take();
}

template Tree<2> build_tree<2>(const std::vector<Primitive<2>>&, double, std::uint32_t);
template Tree<3> build_tree<3>(const std::vector<Primitive<3>>&, double, std::uint32_t);

}  // namespace sightline
