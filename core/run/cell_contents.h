// What the cells of a complex hold, for a run that meets it cell by cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/problem.h"
#include "core/space/cell_complex.h"

namespace sightline {

namespace detail {

inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
}

}  // namespace detail

/// 2D: as the cell complex has it.
template <int D>
class CellContents {
public:
    CellContents() = default;
    explicit CellContents(const Problem<D>&) {}

    std::span<const HalfFacet> facets_of(const CellComplex<D>& cells, std::uint32_t cell) const {
        return cells.facets_of(cell);
    }
    /// Of the neighbour behind facet i of the cell, in any order.
    std::span<const std::uint32_t> corners_behind(const CellComplex<D>& cells, std::uint32_t cell, std::size_t i,
                                                  std::array<std::uint32_t, 4>& /*place for them*/) const {
        return cells.corners_of(cells.facets_of(cell)[i].neighbour);
    }

    /// Meets what the cell holds from counters.offset on, as meet() does with culls. False when the budget ended
    /// before the last of it.
    bool meet(const Problem<D>& problem, bool culled_costs, std::uint32_t cell, Drawn& drawn,
              Counters& counters) const {
        const auto primitives = problem.cells->primitives_of(cell);
        for (; counters.offset < primitives.size(); ++counters.offset)
            if (!sightline::meet(problem, culled_costs, primitives[counters.offset], true, drawn, counters))
                return false;
        return true;
    }

    /// What stands at a place of CellComplex::cell_primitives.
    std::uint32_t held_at(const CellComplex<D>& cells, std::uint32_t place) const {
        return cells.cell_primitives[place];
    }
    /// Calls each(first place, how many, Four) for what the cell holds, four or fewer at a time: bits say of which the
    /// view shows them, or does not show them, for sure.
    struct Four {
        unsigned no = 0, yes = 0;
    };
    template <typename Each>
    void by_fours(const CellComplex<D>& cells, std::uint32_t cell, Each each) const {
        const std::uint32_t end = cells.cell_primitive_begin[cell + 1];
        for (std::uint32_t place = cells.cell_primitive_begin[cell]; place < end; place += 4)
            each(place, std::min(4u, end - place), Four{});
    }
    /// Meets it, as meet() does with culls.
    bool meet_one(const Problem<D>& problem, bool culled_costs, std::uint32_t held, Drawn& drawn,
                  Counters& counters) const {
        return sightline::meet(problem, culled_costs, held, true, drawn, counters);
    }

    // What asks for memory ahead changes nothing else.
    void prefetch_cell(const CellComplex<D>& cells, std::uint32_t cell) const {
        detail::prefetch(cells.facets_of(cell).data());
        detail::prefetch(&cells.cell_primitive_begin[cell]);
    }
    void prefetch_contents(const CellComplex<D>& cells, std::uint32_t cell) const {
        detail::prefetch(cells.primitives_of(cell).data());
    }
};

/// 3D: floats that say of most triangles whether the view shows them, and the exact tests for the others.
template <>
class CellContents<3> {
public:
    CellContents() = default;
    explicit CellContents(const Problem<3>& problem) {
        const CellTriangles& triangles = triangles_of(*problem.cells, *problem.scene);
        triangles_ = triangles.rows().data();
        if (!problem.cells->has_boxes()) rows_ = cell_rows_of(*problem.cells).data();
        filter_ = ShownFilter(problem.view, triangles);
    }

    std::span<const HalfFacet> facets_of(const CellComplex<3>& cells, std::uint32_t cell) const {
        return rows_ ? rows_[cell].facets : cells.facets_of(cell);
    }
    std::span<const std::uint32_t> corners_behind(const CellComplex<3>& cells, std::uint32_t cell, std::size_t i,
                                                  std::array<std::uint32_t, 4>& place) const {
        if (!rows_) return cells.corners_of(cells.facets_of(cell)[i].neighbour);
        place = rows_[cell].corners;
        place[i] = rows_[cell].apex[i];
        return place;
    }

    bool meet(const Problem<3>& problem, bool culled_costs, std::uint32_t cell, Drawn& drawn,
              Counters& counters) const {
        const auto row = held_by(*problem.cells, cell);
        if (row.empty()) return true;
        meet_fours(problem, culled_costs, row, drawn, counters);
        for (; counters.offset < row.size(); ++counters.offset)
            if (!meet_one(problem, culled_costs, row[counters.offset], drawn, counters)) return false;
        return true;
    }

    const CellTriangle& held_at(const CellComplex<3>&, std::uint32_t place) const { return triangles_[place]; }
    /// Of those side by side from there on: three behind the last can be read.
    const CellTriangle* from(std::uint32_t place) const { return triangles_ + place; }
    template <typename Each>
    void by_fours(const CellComplex<3>& cells, std::uint32_t cell, Each each) const {
        const ShownFilter filter = filter_;  // a copy that stays in registers
        const std::uint32_t end = cells.cell_primitive_begin[cell + 1];
        for (std::uint32_t place = cells.cell_primitive_begin[cell]; place < end; place += 4) {
            const ShownFilter::Four four = filter.of_four(triangles_ + place);
            each(place, std::min(4u, end - place), four);
        }
    }
    bool meet_one(const Problem<3>& problem, bool culled_costs, const CellTriangle& held, Drawn& drawn,
                  Counters& counters) const {
        const std::uint32_t primitive = held.primitive();
        if (drawn.has(primitive)) return true;
        const Showing shown = filter_.of(held);
        const bool culled = shown == Showing::no || (shown == Showing::unsure && !shows(problem, primitive));
        return add_met(problem.budget, culled_costs, {primitive, culled}, drawn, counters);
    }

    void prefetch_cell(const CellComplex<3>& cells, std::uint32_t cell) const {
        if (rows_)
            detail::prefetch(rows_ + cell);
        else
            detail::prefetch(&cells.cell_facet_begin[cell]);
        detail::prefetch(&cells.cell_primitive_begin[cell]);
    }
    void prefetch_contents(const CellComplex<3>& cells, std::uint32_t cell) const {
        const auto row = held_by(cells, cell);
        for (std::size_t i = 0; i < row.size() && i < ahead; i += 2) detail::prefetch(&row[i]);
    }

private:
    std::span<const CellTriangle> held_by(const CellComplex<3>& cells, std::uint32_t cell) const {
        return {triangles_ + cells.cell_primitive_begin[cell], cells.count(cell)};
    }

    /// As long as there are four and the budget has place for them.
    void meet_fours(const Problem<3>& problem, bool culled_costs, std::span<const CellTriangle> row, Drawn& drawn,
                    Counters& counters) const {
        const auto count = static_cast<std::uint32_t>(row.size());
        const ShownFilter filter = filter_;  // a copy that stays in registers
        Drawn::Tail tail = drawn.tail(counters.touched_count, count - counters.offset);
        std::uint32_t i = counters.offset, left = 0, spent = 0, rendered = 0;
        if (counters.spent < problem.budget) left = problem.budget - counters.spent;
        for (; i + 4 <= count && left >= 4; i += 4) {
            const CellTriangle* const four = &row[i];
            detail::prefetch(four + ahead);
            detail::prefetch(four + ahead + 2);
            // What was met before is tested again, and nothing branches: what comes out is as good as random.
            const ShownFilter::Four shown = filter.of_four(four);
            unsigned culled = shown.no, fresh = 0;
            for (unsigned lane = 0; lane < 4; ++lane) fresh |= unsigned{tail.put(four[lane].primitive())} << lane;
            if (const unsigned unsure = fresh & ~(shown.no | shown.yes)) [[unlikely]]
                for (unsigned lane = 0; lane < 4; ++lane)
                    if (unsure >> lane & 1) culled |= unsigned{!shows(problem, four[lane].primitive())} << lane;
            for (unsigned lane = 0; lane < 4; ++lane)
                tail.append_if(fresh >> lane & 1, {four[lane].primitive(), (culled >> lane & 1) != 0});
            const std::uint32_t shown_ones = ones(fresh & ~culled);
            rendered += shown_ones;
            const std::uint32_t cost = culled_costs ? ones(fresh) : shown_ones;
            left -= cost;
            spent += cost;
        }
        counters.offset = i;
        counters.spent += spent;
        counters.rendered_count += rendered;
        counters.touched_count = drawn.end(tail);
    }

    /// Of the four lowest bits.
    static std::uint32_t ones(unsigned bits) {
        return static_cast<std::uint32_t>(0x4332322132212110u >> (4 * (bits & 15)) & 15);
    }

    static constexpr std::uint32_t ahead = 24;

    const CellTriangle* triangles_ = nullptr;
    const CellRow* rows_ = nullptr;  ///< nullptr: the cells are boxes
    ShownFilter filter_;
};

}  // namespace sightline
