// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/reference_tree.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/predicates.h"
#include "core/space/triangle_test.h"

namespace sightline {

namespace {

bool touches(const Primitive<2>& segment, const Box<2>& box) {
    // The box lies on one side of the line, or the segment beside it.
    for (int i = 0; i < 2; ++i)
        if (std::max(segment[0][i], segment[1][i]) < box.min[i] || std::min(segment[0][i], segment[1][i]) > box.max[i])
            return false;
    bool left = false, right = false;
    for (const Vec<2>& corner : box.corners()) {
        const int side = orient(segment[0], segment[1], corner);
        left |= side >= 0;
        right |= side <= 0;
    }
    return left && right;
}

bool touches(const Primitive<3>& triangle, const Box<3>& box) { return TriangleTest(triangle).meets(box); }

template <int D>
class ReferenceBuilder {
public:
    ReferenceBuilder(const Scene<D>& scene, ReferenceTree<D>& tree) : scene_(scene), tree_(tree) {
        if (scene.primitives.empty()) return;
        for (const Primitive<D>& primitive : scene.primitives) {
            Box<D> box;
            for (const Vec<D>& corner : primitive) box.add(corner);
            bounds_.push_back(box);
        }
        std::vector<std::uint32_t> all(scene.primitives.size());
        std::iota(all.begin(), all.end(), 0u);
        add_node(none);
        fill(0, 0, std::move(all));
    }

private:
    std::uint32_t space_children(std::uint32_t node) const {
        std::uint32_t count = 1;
        for (int i = 0; i < D; ++i) count <<= tree_.space.splits(node, i);
        return count;
    }
    void add_node(std::uint32_t parent) {
        tree_.boxes.nodes.emplace_back();
        tree_.parent.push_back(parent);
        tree_.leaf_of.push_back(none);
    }

    void fill(std::uint32_t node, std::uint32_t space, std::vector<std::uint32_t> held) {
        BoxTree<D>& boxes = tree_.boxes;
        const auto begin = static_cast<std::uint32_t>(boxes.primitives.size());
        Box<D> box;
        for (const std::uint32_t primitive : held) box.add(bounds_[primitive]);
        // What reaches beyond the root stays in the box: nothing may lie in none.
        if (space != 0) {
            const Box<D>& part = tree_.space.nodes[space].box;
            box = {glm::max(box.min, part.min), glm::min(box.max, part.max)};
        }
        boxes.nodes[node].box = box;
        const std::uint32_t first = tree_.space.nodes[space].first_child;
        if (first == none) {
            boxes.primitives.insert(boxes.primitives.end(), held.begin(), held.end());
            tree_.leaf_of[node] = tree_.space.nodes[space].leaf;
        } else {
            std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> children;
            for (std::uint32_t child = first; child < first + space_children(space); ++child) {
                std::vector<std::uint32_t> in_child;
                for (const std::uint32_t primitive : held)
                    if (reaches(primitive, child)) in_child.push_back(primitive);
                if (!in_child.empty()) children.emplace_back(child, std::move(in_child));
            }
            if (children.size() == 1) return fill(node, children.front().first, std::move(held));
            const auto at = static_cast<std::uint32_t>(boxes.nodes.size());
            boxes.nodes[node].first_child = at;
            boxes.nodes[node].child_count = static_cast<std::uint32_t>(children.size());
            for (std::size_t i = 0; i < children.size(); ++i) add_node(node);
            held = {};
            for (std::uint32_t i = 0; i < children.size(); ++i)
                fill(at + i, children[i].first, std::move(children[i].second));
        }
        boxes.nodes[node].begin = begin;
        boxes.nodes[node].end = static_cast<std::uint32_t>(boxes.primitives.size());
    }

    bool reaches(std::uint32_t primitive, std::uint32_t space) const {
        const Box<D>&a = bounds_[primitive], &b = tree_.space.nodes[space].box;
        for (int i = 0; i < D; ++i)
            if (a.max[i] < b.min[i] || a.min[i] > b.max[i]) return false;
        return touches(scene_.primitives[primitive], b);
    }

    const Scene<D>& scene_;
    ReferenceTree<D>& tree_;
    std::vector<Box<D>> bounds_;
};

}  // namespace

template <int D>
ReferenceTree<D> build_reference_tree(const Scene<D>& scene, TreeKind kind, std::uint32_t leaf, double least_side) {
    ReferenceTree<D> tree;
    tree.space = kind == TreeKind::kd ? build_kd_tree<D>(scene.primitives, least_side, leaf)
                                      : build_tree<D>(scene.primitives, least_side, leaf);
    ReferenceBuilder<D>(scene, tree);
    if constexpr (D == 3) tree.boxes.facing = FacingPlanes(scene, tree.boxes.primitives);
    return tree;
}

template ReferenceTree<2> build_reference_tree<2>(const Scene<2>&, TreeKind, std::uint32_t, double);
template ReferenceTree<3> build_reference_tree<3>(const Scene<3>&, TreeKind, std::uint32_t, double);

}  // namespace sightline
