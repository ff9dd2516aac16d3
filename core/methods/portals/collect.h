// What of a scene lies in a view and has not been met: box by box, or from a list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/problem.h"
#include "core/space/box_tree.h"

namespace sightline {

template <int D>
bool is_seen_in(const Problem<D>& problem, const View<D>& view, std::uint32_t primitive) {
    return turns_a_seen_side(problem, primitive) && in_view(view, problem.primitives()[primitive]);
}

/// Appends those for which `counts(primitive)` holds, in an order that the boxes give.
template <int D, typename Counts>
void collect_boxes(const Problem<D>& problem, const View<D>& view, const Drawn& drawn, Counts counts,
                   std::vector<std::uint32_t>& found) {
    const BoxTree<D>& tree = problem.boxes();
    std::vector<std::uint32_t> nodes;
    if (!tree.nodes.empty()) nodes.push_back(0);
    while (!nodes.empty()) {
        const std::uint32_t node = nodes.back();
        nodes.pop_back();
        const typename BoxTree<D>::Node& at = tree.nodes[node];
        const auto corners = at.box.corners();
        if (!in_view(view, std::span<const Vec<D>>(corners))) continue;
        const bool whole = all_in_view(view, std::span<const Vec<D>>(corners));
        if (!whole && at.first_child != none) {
            nodes.insert(nodes.end(), {at.first_child + 1, at.first_child});
            continue;
        }
        for (const std::uint32_t primitive : tree.primitives_of(node)) {
            if (drawn.has(primitive) || !counts(primitive)) continue;
            if (whole ? turns_a_seen_side(problem, primitive) : is_seen_in(problem, view, primitive))
                found.push_back(primitive);
        }
    }
}

template <int D>
void collect_list(const Problem<D>& problem, const View<D>& view, const Drawn& drawn,
                  std::span<const std::uint32_t> list, std::vector<std::uint32_t>& found) {
    for (const std::uint32_t primitive : list)
        if (!drawn.has(primitive) && is_seen_in(problem, view, primitive)) found.push_back(primitive);
}

}  // namespace sightline
