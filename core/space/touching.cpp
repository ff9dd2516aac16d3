// Leaves that touch at an edge or a corner only: "all of its neighbors" of the gem.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/space/box_facets.h"

namespace sightline {

namespace {

template <int D>
class TouchingLeaves {
public:
    struct Contact {
        std::uint32_t low, high;  ///< leaves, by number
        Box<D> shared;
    };

    explicit TouchingLeaves(const Tree<D>& tree) : tree_(tree) { inside(0); }

    std::vector<Contact> take() {
        std::sort(found_.begin(), found_.end(),
                  [](const Contact& a, const Contact& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
        return std::move(found_);
    }

private:
    std::uint32_t child_count(std::uint32_t node) const {
        std::uint32_t count = 1;
        for (int i = 0; i < D; ++i) count <<= tree_.splits(node, i);
        return count;
    }
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].first_child == none; }

    void inside(std::uint32_t node) {
        if (is_leaf(node)) return;
        const std::uint32_t first = tree_.nodes[node].first_child, count = child_count(node);
        for (std::uint32_t a = 0; a < count; ++a) {
            inside(first + a);
            for (std::uint32_t b = a + 1; b < count; ++b) between(first + a, first + b);
        }
    }

    /// The leaves below one that touch those below the other. Coordinates of planes are handed down unchanged, so equal
    /// ones are equal doubles.
    void between(std::uint32_t a, std::uint32_t b) {
        const Box<D>&of_a = tree_.nodes[a].box, &of_b = tree_.nodes[b].box;
        const Box<D> shared{glm::max(of_a.min, of_b.min), glm::min(of_a.max, of_b.max)};
        int flat = 0;
        for (int i = 0; i < D; ++i) {
            if (shared.min[i] > shared.max[i]) return;
            flat += shared.min[i] == shared.max[i];
        }
        if (is_leaf(a) && is_leaf(b)) {
            const auto [low, high] = std::minmax(tree_.nodes[a].leaf, tree_.nodes[b].leaf);
            if (flat > 1) found_.push_back({low, high, shared});
            return;
        }
        if (is_leaf(a)) std::swap(a, b);
        const std::uint32_t first = tree_.nodes[a].first_child;
        for (std::uint32_t c = 0; c < child_count(a); ++c) between(first + c, b);
    }

    const Tree<D>& tree_;
    std::vector<Contact> found_;
};

}  // namespace

template <int D>
void link_touching(const Tree<D>& tree, BoxFacets<D>& facets) {
    for (const auto& contact : TouchingLeaves<D>(tree).take())
        facets.link(contact.low, contact.high, facets.add_contact(contact.shared.min, contact.shared.max));
}

template void link_touching<2>(const Tree<2>&, BoxFacets<2>&);
template void link_touching<3>(const Tree<3>&, BoxFacets<3>&);

}  // namespace sightline
