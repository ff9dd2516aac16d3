// The boxes of a method that walks a tree of them, as pictures show them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/session/session.h"

namespace sightline {

template <int D>
bool walks_boxes(const Session<D>& session) {
    return session.method().pops == Kind::node;
}

template <int D>
struct ShownBox {
    std::uint32_t node = none;
    CellState state = CellState::clean;
    Box<D> box;
};

/// Those that wait, that are dropped and that are drawn, parents before their children; of an opened box its halves.
/// None for a method that walks no boxes.
template <int D>
std::vector<ShownBox<D>> shown_boxes(const Session<D>& session);

/// Of the shown boxes that hold the point, else of those within reach of it, the smallest; none: there is none. Boxes
/// may be flat.
std::uint32_t box_near(const Session<2>& session, const Vec<2>& at, double reach);

/// The first shown box that a ray meets; none: it meets none. `from` does not count as in one.
std::uint32_t box_along(std::span<const ShownBox<3>> boxes, const Vec<3>& from, const Vec<3>& along);

/// What the last step popped; none where that was no box.
template <int D>
std::uint32_t last_node(const Session<D>& session) {
    return session.position() > 0 ? id_of(session.timeline().steps[session.position() - 1].item, Kind::node) : none;
}

/// The one that the last step popped.
template <int D>
std::optional<Box<D>> last_box(const Session<D>& session);

/// The one that is selected.
template <int D>
std::optional<Box<D>> selected_box(const Session<D>& session);

/// What pictures of depth mark: the selected cell or primitive, else what the last step popped; of kind none where that
/// was neither a cell nor a box.
template <int D>
Item marked_item(const Session<D>& session);

}  // namespace sightline
