// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_boxes.h"

#include "core/space/box_tree.h"

namespace sightline {

template <int D>
std::vector<ShownBox<D>> shown_boxes(const Session<D>& session) {
    std::vector<ShownBox<D>> shown;
    if (!walks_boxes(session)) return shown;
    const BoxTree<D>& tree = *session.traversal().boxes();
    const Run<D>& run = session.traversal();
    const auto state = [&](std::uint32_t node) { return run.mark(Item{node, Kind::node}).state; };
    std::vector<std::uint32_t> below;
    if (!tree.nodes.empty()) below.push_back(0);
    while (!below.empty()) {
        const std::uint32_t node = below.back();
        below.pop_back();
        const CellState here = state(node);
        if (here == CellState::clean) continue;
        const std::uint32_t child = tree.nodes[node].first_child;
        if (here == CellState::projected && child != none && state(child) != CellState::clean)
            for (std::uint32_t i = tree.nodes[node].child_count; i-- > 0;) below.push_back(child + i);
        else
            shown.push_back({node, here, tree.nodes[node].box});
    }
    return shown;
}

template <int D>
std::optional<Box<D>> last_box(const Session<D>& session) {
    if (session.position() == 0) return std::nullopt;
    const std::uint32_t node = id_of(session.timeline().steps[session.position() - 1].item, Kind::node);
    if (node == none) return std::nullopt;
    return session.traversal().boxes()->nodes[node].box;
}

template <int D>
Item marked_item(const Session<D>& session) {
    if (session.selected_cell != none) return cell_item(session.selected_cell);
    if (session.selected_primitive != none) return primitive_item(session.selected_primitive);
    if (session.position() == 0) return {};
    const Item last = session.timeline().steps[session.position() - 1].item;
    return last.kind == Kind::node || last.kind == Kind::cell ? last : Item{};
}

#define SIGHTLINE_INSTANTIATE(D)                                         \
    template std::vector<ShownBox<D>> shown_boxes<D>(const Session<D>&); \
    template std::optional<Box<D>> last_box<D>(const Session<D>&);       \
    template Item marked_item<D>(const Session<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
