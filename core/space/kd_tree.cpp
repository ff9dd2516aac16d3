// The kd-tree: longest side first, at the median.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/space/tree.h"

namespace sightline {

namespace {

template <int D>
class KdBuilder {
public:
    KdBuilder(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity)
        : capacity_(leaf_capacity) {
        middles_.reserve(primitives.size());
        for (const Primitive<D>& primitive : primitives) {
            Vec<D> sum(0);
            for (const Vec<D>& corner : primitive) sum += corner;
            middles_.push_back(sum / static_cast<double>(primitive.size()));
        }
        Box<D> box = bounds<D>(primitives);
        if (box.empty() || box.longest_side() == 0) {
            const Vec<D> centre = box.empty() ? Vec<D>(0) : box.centre();
            box = {centre - Vec<D>(0.5), centre + Vec<D>(0.5)};
        }
        smallest_side_ = box.longest_side() * error_bound;
        for (int i = 0; i < D; ++i)
            if (const double side = box.max[i] - box.min[i]; side < smallest_side_) {
                box.min[i] -= (smallest_side_ - side) / 2;
                box.max[i] += (smallest_side_ - side) / 2;
            }
        tree_.nodes.push_back({box});
        split_below(0, 0, middles_.size());
    }

    Tree<D> take() { return std::move(tree_); }

private:
    /// The node holds the middles [begin, end), which it sorts into those of its children.
    void split_below(std::uint32_t node, std::size_t begin, std::size_t end) {
        const Box<D> box = tree_.nodes[node].box;
        const Vec<D> extent = box.extent();
        int axis = 0;
        for (int i = 1; i < D; ++i)
            if (extent[i] > extent[axis]) axis = i;
        const double half = box.min[axis] + extent[axis] / 2;
        if (end - begin <= capacity_ || extent[axis] < smallest_side_ ||
            !(box.min[axis] < half && half < box.max[axis])) {  // the last: out of doubles
            tree_.nodes[node].leaf = static_cast<std::uint32_t>(tree_.leaves.size());
            tree_.leaves.push_back(node);
            return;
        }
        double plane = median(axis, begin, end);
        const auto below = [&](const Vec<D>& middle) { return middle[axis] < plane; };
        const auto first = middles_.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = middles_.begin() + static_cast<std::ptrdiff_t>(end);
        if (!(box.min[axis] < plane && plane < box.max[axis]) || std::none_of(first, last, below)) plane = half;
        const auto upper = static_cast<std::size_t>(std::partition(first, last, below) - middles_.begin());

        const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[node].first_child = child;
        for (const bool high : {false, true}) {
            Box<D> part = box;
            (high ? part.min : part.max)[axis] = plane;
            tree_.nodes.push_back({part});
        }
        split_below(child, begin, upper);
        split_below(child + 1, upper, end);
    }

    /// Between the two middle ones of an even number.
    double median(int axis, std::size_t begin, std::size_t end) {
        along_.clear();
        for (std::size_t i = begin; i < end; ++i) along_.push_back(middles_[i][axis]);
        const auto centre = along_.begin() + static_cast<std::ptrdiff_t>(along_.size() / 2);
        std::nth_element(along_.begin(), centre, along_.end());
        if (along_.size() % 2 == 1) return *centre;
        const double before = *std::max_element(along_.begin(), centre);
        return before + (*centre - before) / 2;
    }

    Tree<D> tree_;
    std::vector<Vec<D>> middles_;
    std::vector<double> along_;  ///< scratch
    double smallest_side_ = 0;
    std::size_t capacity_;
};

}  // namespace

template <int D>
Tree<D> build_kd_tree(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity) {
    return KdBuilder<D>(primitives, error_bound, leaf_capacity).take();
}

template Tree<2> build_kd_tree<2>(const std::vector<Primitive<2>>&, double, std::uint32_t);
template Tree<3> build_kd_tree<3>(const std::vector<Primitive<3>>&, double, std::uint32_t);

}  // namespace sightline
