// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/reference.h"

#include <algorithm>

#include "core/base/trig.h"

namespace sightline {

namespace {

/// A share below this counts as 0: clipping rounds the ends of a piece by about 1e-16 of its length, so a piece that
/// only touches a cell may seem to reach into it by that much.
constexpr double share_rounding = 1e-12;

/// Angle at the eye under which the part of the piece inside the cell is seen, in radians.
double angle_inside(const CellComplex<2>& cells, std::uint32_t cell, const VisiblePiece& piece, const Vec<2>& eye) {
    double begin = 0, end = 1;
    for (const HalfFacet& half : cells.facets_of(cell)) {
        const auto [a, b] = facet_ends(cells, half);
        const double from = cross(b - a, piece.from - a), to = cross(b - a, piece.to - a);
        if (from < 0 && to < 0) return 0;
        if (from < 0) begin = std::max(begin, from / (from - to));
        if (to < 0) end = std::min(end, from / (from - to));
    }
    if (!(begin < end)) return 0;
    const Vec<2> d = piece.to - piece.from;
    const Vec<2> u = piece.from + d * begin - eye, v = piece.from + d * end - eye;
    return std::max(0.0, angle_of(cross(u, v), glm::dot(u, v)));
}

}  // namespace

Reference exact_reference(const std::vector<Primitive<2>>& primitives, const CellComplex<2>& cells,
                          const View<2>& view) {
    VisibleSet set = exact_visible_set(primitives, view);
    Reference reference{"exact", std::move(set.visible), set.count, {}, set.eye_on, std::move(set.pieces)};
    reference.cell_share.assign(cells.cell_count(), 0);
    std::vector<std::vector<std::uint32_t>> pieces_of(primitives.size());
    double total = 0;
    for (std::uint32_t i = 0; i < reference.pieces.size(); ++i) {
        const VisiblePiece& piece = reference.pieces[i];
        pieces_of[piece.primitive].push_back(i);
        const Vec<2> u = piece.from - view.eye, v = piece.to - view.eye;
        total += std::max(0.0, angle_of(cross(u, v), glm::dot(u, v)));
    }
    if (total == 0) return reference;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        double angle = 0;
        for (const std::uint32_t primitive : cells.primitives_of(cell))
            for (const std::uint32_t piece : pieces_of[primitive])
                angle += angle_inside(cells, cell, reference.pieces[piece], view.eye);
        const double share = angle / total;
        if (share > share_rounding) reference.cell_share[cell] = share;
    }
    return reference;
}

}  // namespace sightline
