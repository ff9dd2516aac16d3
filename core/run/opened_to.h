// How far a walk over a tree of boxes has come towards one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/marks.h"
#include "core/space/box_tree.h"

namespace sightline {

/// The box on the way from the root to `node` where the walk stands: the first that it has not opened (one that it took
/// as a whole is none), or the node itself.
template <int D>
std::uint32_t opened_to(const BoxTree<D>& tree, const Marks& marks, std::uint32_t node) {
    std::uint32_t at = 0;
    while (at != node && marks[at].state == CellState::projected && tree.nodes[at].first_child != none) {
        const std::uint32_t next = tree.child_at(at, tree.nodes[node].begin);
        if (marks[next].state == CellState::clean) break;
        at = next;
    }
    return at;
}

}  // namespace sightline
