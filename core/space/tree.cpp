// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/tree.h"

#include <algorithm>
#include <span>

namespace sightline {

namespace {

template <int D>
class Builder {
public:
    Builder(const std::vector<Primitive<D>>& primitives, double error_bound) {
        Box<D> box;
        for (const Primitive<D>& p : primitives)
            for (const Vec<D>& v : p) {
                box.add(v);
                points_.push_back(v);
            }
        smallest_side_ = box.longest_side() * error_bound;
        tree_.nodes.push_back({root(box)});
        split(0, points_);
    }
    Tree<D> take() { return std::move(tree_); }

private:
    static Box<D> root(const Box<D>& box) {
        const double side = box.longest_side();
        if (box.empty() || side == 0) {
            const Vec<D> centre = box.empty() ? Vec<D>(0) : box.centre();
            return {centre - Vec<D>(0.5), centre + Vec<D>(0.5)};
        }
        // Rounding may leave an extreme vertex an ulp outside the cube: every vertex must lie in the root.
        return {glm::min(box.min, box.centre() - Vec<D>(side / 2)), glm::max(box.max, box.centre() + Vec<D>(side / 2))};
    }

    bool is_leaf(const Box<D>& box, std::span<const Vec<D>> points) const {
        if (box.max.x - box.min.x < smallest_side_ || points.size() < 2) return true;
        const Vec<D> middle = box.centre();
        for (int i = 0; i < D; ++i)
            if (!(box.min[i] < middle[i] && middle[i] < box.max[i])) return true;  // out of doubles
        return std::all_of(points.begin(), points.end(), [&](const Vec<D>& p) { return p == points.front(); });
    }

    void split(std::uint32_t node, std::span<Vec<D>> points) {
        const Box<D> box = tree_.nodes[node].box;
        if (is_leaf(box, points)) {
            tree_.nodes[node].leaf = static_cast<std::uint32_t>(tree_.leaves.size());
            tree_.leaves.push_back(node);
            return;
        }
        const Vec<D> middle = box.centre();
        const auto first_child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[node].first_child = first_child;
        for (int child = 0; child < Tree<D>::child_count; ++child) {
            Box<D> part = box;
            for (int i = 0; i < D; ++i) (child >> i & 1 ? part.min : part.max)[i] = middle[i];
            tree_.nodes.push_back({part});
        }
        for (int child = 0; child < Tree<D>::child_count; ++child) {
            const auto rest = std::partition(points.begin(), points.end(), [&](const Vec<D>& p) {
                for (int i = 0; i < D; ++i)
                    if ((p[i] >= middle[i]) != (child >> i & 1)) return false;
                return true;
            });
            const auto size = static_cast<std::size_t>(rest - points.begin());
            split(first_child + static_cast<std::uint32_t>(child), points.first(size));
            points = points.subspan(size);
        }
    }

    Tree<D> tree_;
    std::vector<Vec<D>> points_;
    double smallest_side_ = 0;
};

}  // namespace

template <int D>
Tree<D> build_tree(const std::vector<Primitive<D>>& primitives, double error_bound) {
    return Builder<D>(primitives, error_bound).take();
}

template Tree<2> build_tree<2>(const std::vector<Primitive<2>>&, double);
template Tree<3> build_tree<3>(const std::vector<Primitive<3>>&, double);

}  // namespace sightline
