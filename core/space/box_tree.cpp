// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sightline {

namespace {

/// Half the surface of a box; in 2D half its border.
double half_surface(const Box<2>& box) {
    const Vec<2> side = box.extent();
    return side.x + side.y;
}
double half_surface(const Box<3>& box) {
    const Vec<3> side = box.extent();
    return side.x * side.y + side.y * side.z + side.z * side.x;
}

template <int D>
class BoxTreeBuilder {
public:
    BoxTreeBuilder(const std::vector<Primitive<D>>& primitives, std::uint32_t leaf) : leaf_(leaf) {
        boxes_.reserve(primitives.size());
        for (const Primitive<D>& primitive : primitives) {
            Box<D> box;
            for (const Vec<D>& corner : primitive) box.add(corner);
            boxes_.push_back(box);
        }
        tree_.primitives.resize(primitives.size());
        std::iota(tree_.primitives.begin(), tree_.primitives.end(), 0u);
        if (primitives.empty()) return;
        tree_.nodes.push_back({box_of(0, static_cast<std::uint32_t>(primitives.size())), none, 0,
                               static_cast<std::uint32_t>(primitives.size())});
        split_below(0);
    }

    BoxTree<D> take() { return std::move(tree_); }

private:
    static constexpr int bins = 16;
    struct Bin {
        Box<D> box;
        std::uint32_t count = 0;
    };

    Box<D> box_of(std::uint32_t begin, std::uint32_t end) const {
        Box<D> box;
        for (std::uint32_t i = begin; i < end; ++i) box.add(boxes_[tree_.primitives[i]]);
        return box;
    }

    void split_below(std::uint32_t node) {
        const std::uint32_t begin = tree_.nodes[node].begin, end = tree_.nodes[node].end;
        if (end - begin <= leaf_) return;
        const std::uint32_t middle = parted(begin, end);
        const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[node].first_child = child;
        tree_.nodes.push_back({box_of(begin, middle), none, begin, middle});
        tree_.nodes.push_back({box_of(middle, end), none, middle, end});
        split_below(child);
        split_below(child + 1);
    }

    /// Sorts [begin, end) into two parts, each in its order before; where the second begins.
    std::uint32_t parted(std::uint32_t begin, std::uint32_t end) {
        Box<D> middles;
        for (std::uint32_t i = begin; i < end; ++i) middles.add(boxes_[tree_.primitives[i]].centre());
        const Vec<D> extent = middles.extent();
        int axis = 0;
        for (int i = 1; i < D; ++i)
            if (extent[i] > extent[axis]) axis = i;
        const std::uint32_t half = begin + (end - begin) / 2;
        const double scale = bins / extent[axis];
        if (!(extent[axis] > 0) || !std::isfinite(scale)) return half;
        const auto bin_of = [&](std::uint32_t primitive) {
            const double at = (boxes_[primitive].centre()[axis] - middles.min[axis]) * scale;
            return std::min(static_cast<int>(at), bins - 1);
        };
        std::array<Bin, bins> filled{};
        for (std::uint32_t i = begin; i < end; ++i) {
            Bin& bin = filled[static_cast<std::size_t>(bin_of(tree_.primitives[i]))];
            bin.box.add(boxes_[tree_.primitives[i]]);
            ++bin.count;
        }
        const int place = best_place(filled);
        upper_.clear();
        std::uint32_t kept = begin;
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t primitive = tree_.primitives[i];
            if (bin_of(primitive) < place)
                tree_.primitives[kept++] = primitive;
            else
                upper_.push_back(primitive);
        }
        std::copy(upper_.begin(), upper_.end(), tree_.primitives.begin() + kept);
        return kept;
    }

    /// The number of bins below the best place to cut. Both parts hold something, since the outermost bins do.
    static int best_place(const std::array<Bin, bins>& filled) {
        std::array<double, bins> below{};
        Bin part;
        for (std::size_t i = 0; i + 1 < bins; ++i) {
            part.box.add(filled[i].box);
            part.count += filled[i].count;
            below[i + 1] = half_surface(part.box) * part.count;
        }
        part = {};
        double least = std::numeric_limits<double>::infinity();
        int place = 1;
        for (std::size_t i = bins - 1; i > 0; --i) {
            part.box.add(filled[i].box);
            part.count += filled[i].count;
            const double cost = below[i] + half_surface(part.box) * part.count;
            if (cost < least) {
                least = cost;
                place = static_cast<int>(i);
            }
        }
        return place;
    }

    BoxTree<D> tree_;
    std::vector<Box<D>> boxes_;         ///< of the primitives
    std::vector<std::uint32_t> upper_;  ///< scratch
    std::uint32_t leaf_;
};

}  // namespace

template <int D>
BoxTree<D> build_box_tree(const std::vector<Primitive<D>>& primitives, std::uint32_t leaf) {
    return BoxTreeBuilder<D>(primitives, leaf).take();
}

template BoxTree<2> build_box_tree<2>(const std::vector<Primitive<2>>&, std::uint32_t);
template BoxTree<3> build_box_tree<3>(const std::vector<Primitive<3>>&, std::uint32_t);

}  // namespace sightline
