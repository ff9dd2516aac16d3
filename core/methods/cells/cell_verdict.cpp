// Why a cell has not come into the front.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/methods/cells/cell_base.h"
#include "core/space/cell_in_view.h"

namespace sightline {

template <int D>
Verdict CellBase<D>::why_not(const Item& item) const {
    if (item.kind != Kind::cell) return {};
    switch (marks_[item.id].state) {
        case CellState::unseen:
            return {"outside-view", "it lies outside the view"};
        case CellState::clean:
            if (const Verdict lost = why_lost(item.id)) return lost;
            return why_clean(item.id);
        default:
            return {};
    }
}

/// Breadth first over clean cells, to the cells that will bring it into the front.
template <int D>
Verdict CellBase<D>::why_clean(std::uint32_t cell) const {
    const CellComplex<D>& cells = *this->problem_.cells;
    const auto may_enter = [&](std::uint32_t c) {
        return parameters_.outside_view == OutsideView::enqueue || cell_in_view(cells, this->problem_.view, c);
    };
    if (!may_enter(cell)) return {"outside-view", "it lies outside the view"};
    const std::uint32_t partial = this->counters_.partial_cell;
    // These are projected and their neighbours still to be added: where those were, they are not clean.
    const auto waits = [&](std::uint32_t c) { return c == rewound_cell_ || c == partial; };
    std::vector<std::uint32_t> ring{cell}, next;
    std::vector<std::uint8_t> seen(marks_.size());
    seen[cell] = 1;
    for (std::size_t facets = 1; !ring.empty(); ++facets, ring.swap(next)) {
        next.clear();
        std::uint32_t first = none, waiting = none;
        for (const std::uint32_t from : ring)
            for (const HalfFacet& half : cells.facets_of(from)) {
                const std::uint32_t n = half.neighbour;
                if (n == none || seen[n]) continue;
                seen[n] = 1;
                const Mark mark = marks_[n];
                if (mark.state == CellState::projected && waits(n)) waiting = n;
                if (mark.state == CellState::enqueued && (first == none || comes_before(mark, marks_[first])))
                    first = n;
                if (mark.state == CellState::clean && may_enter(n)) next.push_back(n);
            }
        if (waiting != none) {
            const std::string in =
                item_name(cell_item(waiting)) + (facets == 1 ? "" : ", " + counted(facets, "facet") + " away,");
            if (waiting == rewound_cell_)
                return {"in-step", "the step in " + in + " has not looked across all its facets yet",
                        cell_item(waiting)};
            return {"budget-before-neighbours", "the budget ended in " + in + " before its neighbours were added",
                    cell_item(waiting)};
        }
        if (first == none) continue;
        std::uint32_t rank = 1;
        for (std::uint32_t other = 0; other < marks_.size(); ++other)
            rank += marks_[other].state == CellState::enqueued && comes_before(marks_[other], marks_[first]);
        const std::string place = item_name(cell_item(first)) + ", number " + std::to_string(rank) + " in the front";
        if (facets == 1)
            return {"no-neighbour-projected",
                    "no neighbour is projected yet; of those in the front, the first is " + place, cell_item(first)};
        return {"front-far", "the front is " + counted(facets, "facet") + " away; its nearest cell is " + place,
                cell_item(first)};
    }
    if (this->counters_.front_size == 0 && partial == none)
        return {"front-empty", "the front is empty, and no path inside the view led here"};
    return {"unreachable", "no path inside the view leads here from the front"};
}

template Verdict CellBase<2>::why_clean(std::uint32_t) const;
template Verdict CellBase<3>::why_clean(std::uint32_t) const;
template Verdict CellBase<2>::why_not(const Item&) const;
template Verdict CellBase<3>::why_not(const Item&) const;

}  // namespace sightline
