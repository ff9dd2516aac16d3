// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_cells.h"

#include <array>

namespace sightline {

namespace {

/// Marks the cells that are at most `rings` facets away from the middle.
std::vector<std::uint8_t> near(const CellComplex<3>& cells, std::uint32_t middle, std::uint32_t rings) {
    std::vector<std::uint8_t> marked(cells.cell_count(), 0);
    if (middle == none) return marked;
    marked[middle] = 1;
    std::vector<std::uint32_t> ring{middle}, next;
    for (; rings > 0 && !ring.empty(); --rings) {
        next.clear();
        for (const std::uint32_t cell : ring)
            for (const HalfFacet& half : cells.facets_of(cell))
                if (half.neighbour != none && !marked[half.neighbour]) {
                    marked[half.neighbour] = 1;
                    next.push_back(half.neighbour);
                }
        ring.swap(next);
    }
    return marked;
}

}  // namespace

std::optional<Slice> slice_of(const Session<3>& session) {
    const Settings& set = session.settings();
    if (set.slice == SliceAcross::off) return std::nullopt;
    const Box<3> box = bounds<3>(session.scene().primitives);
    if (box.empty()) return std::nullopt;
    Slice slice;
    if (set.slice != SliceAcross::view) {
        const int axis = static_cast<int>(set.slice) - static_cast<int>(SliceAcross::x);
        slice.normal[axis] = 1;
        slice.offset = box.min[axis] + (box.max[axis] - box.min[axis]) * set.slice_at;
        return slice;
    }
    const Vec<3> eye = session.display_view().eye, away = session.display_view().look_at - eye;
    slice.normal = -away / glm::length(away);
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec<3> p = box.min;
        for (int axis = 0; axis < 3; ++axis)
            if (corner >> axis & 1) p[axis] = box.max[axis];
        const double distance = glm::dot(slice.normal, eye - p);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    nearest = std::max(nearest, 0.0);
    slice.offset = glm::dot(slice.normal, eye) - (nearest + (farthest - nearest) * set.slice_at);
    return slice;
}

std::vector<std::uint8_t> shown_cells(const Session<3>& session, const std::optional<Slice>& slice) {
    const Settings& set = session.settings();
    const CellComplex<3>& cells = session.cells();
    std::vector<std::uint8_t> shown;
    if (set.only == OnlyCells::around)
        shown = near(cells, session.selected_cell != none ? session.selected_cell : last_cell(session), set.around);
    else
        shown.assign(cells.cell_count(), 1);
    if (set.only == OnlyCells::front)
        for (std::uint32_t cell = 0; cell < shown.size(); ++cell)
            shown[cell] = session.mark(cell).state == CellState::enqueued;
    if (slice)
        for (std::uint32_t cell = 0; cell < shown.size(); ++cell)
            if (glm::dot(slice->normal, cells.centre(cell)) > slice->offset) shown[cell] = 0;
    return shown;
}

}  // namespace sightline
