// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::uint32_t box_near(const Session<2>& session, const Vec<2>& at, double reach) {
    std::uint32_t found = none;
    double nearest = reach, smallest = 0;
    for (const ShownBox<2>& shown : shown_boxes(session)) {
        const Vec<2> outside = glm::max(glm::max(shown.box.min - at, at - shown.box.max), Vec<2>(0));
        const double away = std::sqrt(glm::dot(outside, outside)), size = shown.box.longest_side();
        if (away > nearest || (found != none && away == nearest && size >= smallest)) continue;
        nearest = away;
        smallest = size;
        found = shown.node;
    }
    return found;
}

std::uint32_t box_along(std::span<const ShownBox<3>> boxes, const Vec<3>& from, const Vec<3>& along) {
    std::uint32_t found = none;
    double first = std::numeric_limits<double>::infinity();
    for (const ShownBox<3>& shown : boxes) {
        double enter = 0, leave = first;
        for (int i = 0; i < 3; ++i) {
            const double a = (shown.box.min[i] - from[i]) / along[i], b = (shown.box.max[i] - from[i]) / along[i];
            if (along[i] == 0) {
                if (from[i] < shown.box.min[i] || from[i] > shown.box.max[i]) leave = -1;
                continue;
            }
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        if (enter <= 0 || enter > leave || enter >= first) continue;
        first = enter;
        found = shown.node;
    }
    return found;
}

template <int D>
std::optional<Box<D>> last_box(const Session<D>& session) {
    const std::uint32_t node = last_node(session);
    if (node == none) return std::nullopt;
    return session.traversal().boxes()->nodes[node].box;
}

template <int D>
std::optional<Box<D>> selected_box(const Session<D>& session) {
    const BoxTree<D>* const tree = session.traversal().boxes();
    if (!tree || session.selected_node >= tree->nodes.size()) return std::nullopt;
    return tree->nodes[session.selected_node].box;
}

template <int D>
Item marked_item(const Session<D>& session) {
    if (selected_box(session)) return Item{session.selected_node, Kind::node};
    if (session.selected_cell != none) return cell_item(session.selected_cell);
    if (session.selected_primitive != none) return primitive_item(session.selected_primitive);
    if (session.position() == 0) return {};
    const Item last = session.timeline().steps[session.position() - 1].item;
    return last.kind == Kind::node || last.kind == Kind::cell ? last : Item{};
}

#define SIGHTLINE_INSTANTIATE(D)                                         \
    template std::vector<ShownBox<D>> shown_boxes<D>(const Session<D>&); \
    template std::optional<Box<D>> last_box<D>(const Session<D>&);       \
    template std::optional<Box<D>> selected_box<D>(const Session<D>&);   \
    template Item marked_item<D>(const Session<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
