// What of a scene lies in a view and has not been met: box by box, of a room, or from a list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/portals/room_graph.h"
#include "core/space/box_tree.h"

namespace sightline {

template <int D>
bool is_seen_in(const Problem<D>& problem, const View<D>& view, std::uint32_t primitive) {
    return turns_a_seen_side(problem, primitive) && in_view(view, problem.primitives()[primitive]);
}

/// Appends all of the scene, in an order that the boxes give.
template <int D>
void collect_boxes(const Problem<D>& problem, const View<D>& view, const Drawn& drawn,
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
            if (drawn.has(primitive)) continue;
            if (whole ? turns_a_seen_side(problem, primitive) : is_seen_in(problem, view, primitive))
                found.push_back(primitive);
        }
    }
}

enum class InView : std::uint8_t { no, partly, whole };

template <int D>
InView box_in_view(const View<D>& view, const Box<D>& box) {
    const auto corners = box.corners();
    if (!in_view(view, std::span<const Vec<D>>(corners))) return InView::no;
    return all_in_view(view, std::span<const Vec<D>>(corners)) ? InView::whole : InView::partly;
}

/// Appends what of a row of the graph (a room's, or that of the outside) lies in the view, rising.
template <int D>
void collect_row(const Problem<D>& problem, const View<D>& view, const Drawn& drawn, const RoomGraph<D>& graph,
                 std::uint32_t room, std::vector<std::uint32_t>& found) {
    constexpr std::uint32_t size = RoomGraph<D>::block_size, blocks_a_group = RoomGraph<D>::blocks_a_group;
    const auto row = graph.contents.of(room);
    const std::uint32_t first = graph.first_block[room], end = graph.first_block[room + 1];
    std::array<SideSeen, size> sides;
    InView group = InView::no;
    for (std::uint32_t block = first; block < end; ++block) {
        if ((block - first) % blocks_a_group == 0)
            group = box_in_view(view, graph.groups[graph.first_group[room] + (block - first) / blocks_a_group]);
        if (group == InView::no) {
            block += blocks_a_group - 1;
            continue;
        }
        const InView here = group == InView::whole ? group : box_in_view(view, graph.blocks[block]);
        if (here == InView::no) continue;
        const std::uint32_t begin = (block - first) * size;
        const auto of_block = row.subspan(begin, std::min<std::size_t>(size, row.size() - begin));
        sides.fill(SideSeen::unsure);
        if constexpr (D == 3)
            graph.facing.tell(view.eye, graph.contents.begin[room] + begin, std::span(sides).first(of_block.size()));
        for (std::size_t i = 0; i < of_block.size(); ++i) {
            const std::uint32_t primitive = of_block[i];
            if (sides[i] == SideSeen::away || drawn.has(primitive)) continue;
            if (sides[i] == SideSeen::unsure && !turns_a_seen_side(problem, primitive)) continue;
            if (here == InView::whole || in_view(view, problem.primitives()[primitive])) found.push_back(primitive);
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
