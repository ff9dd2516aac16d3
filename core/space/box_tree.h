// A tree of boxes over the primitives of a scene: what conservative methods walk and test.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/scene/scene.h"
#include "core/space/facing.h"

namespace sightline {

/// How many primitives a leaf may hold. Measured in city, cars and plant with method `boxes`: with fewer the boxes cost
/// more than they save, with more too much is drawn that a tighter box would have hidden.
inline constexpr std::uint32_t box_tree_leaf = 32;

/// Nodes in a flat array, root first, the children of a node side by side and behind it. Boxes are tight. A scene
/// without primitives has no node, and no node is without primitives.
template <int D>
struct BoxTree {
    struct Node {
        Box<D> box;
        std::uint32_t first_child = none;  ///< none: a leaf
        std::uint32_t begin = 0, end = 0;  ///< what it holds: primitives[begin, end), those of its children in turn
        std::uint32_t child_count = 2;     ///< of an inner node
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> primitives;  ///< leaf by leaf; ascending in a leaf
    FacingPlanes facing;                    ///< 3D, in that order; who draws by it fills it

    std::span<const std::uint32_t> primitives_of(std::uint32_t node) const {
        return std::span(primitives).subspan(nodes[node].begin, nodes[node].end - nodes[node].begin);
    }
    /// Of what the node holds, in turn. 2D: all is seen; unsure where `facing` was not filled.
    void tell_facing(std::uint32_t node, const Vec<D>& eye, std::vector<SideSeen>& out) const {
        const Node& at = nodes[node];
        out.assign(at.end - at.begin, D == 2 ? SideSeen::seen : SideSeen::unsure);
        if constexpr (D == 3)
            if (!facing.empty()) facing.tell(eye, at.begin, out);
    }
    /// The child of an inner node that holds that place of `primitives`.
    std::uint32_t child_at(std::uint32_t node, std::uint32_t place) const {
        std::uint32_t child = nodes[node].first_child;
        while (place >= nodes[child].end) ++child;
        return child;
    }
    std::size_t memory_bytes() const {
        return nodes.capacity() * sizeof(Node) + primitives.capacity() * sizeof(std::uint32_t) + facing.memory_bytes();
    }
};

/// Each primitive stands in one leaf, so boxes of neighbours may overlap. Splits a node while it holds more than `leaf`
/// primitives: across the longest side of their middles' box, where the
/// boxes of both parts, each weighted by what it holds, have the least area (the surface area heuristic of ray tracers,
/// Goldsmith and Salmon 1987, over 16 places); in half where all middles are one. `leaf` at least 1.
template <int D>
BoxTree<D> build_box_tree(const std::vector<Primitive<D>>& primitives, std::uint32_t leaf = box_tree_leaf);

extern template BoxTree<2> build_box_tree<2>(const std::vector<Primitive<2>>&, std::uint32_t);
extern template BoxTree<3> build_box_tree<3>(const std::vector<Primitive<3>>&, std::uint32_t);

/// The box tree of one scene, built when it is first asked for. Any thread may ask.
template <int D>
class SceneBoxes {
public:
    const BoxTree<D>& of(const Scene<D>& scene) const {
        std::call_once(once_, [&] {
            tree_ = build_box_tree<D>(scene.primitives);
            if constexpr (D == 3) tree_.facing = FacingPlanes(scene, tree_.primitives);
        });
        return tree_;
    }

private:
    mutable std::once_flag once_;
    mutable BoxTree<D> tree_;
};

}  // namespace sightline
