// The traversal: RenderingLoop of TVCG fig. 4 (TR fig. 5) for cells, and its like for orders of primitives. One step is
// one pop, or one batch of primitives; one, n or all steps run the same code.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/traversal/terms.h"
#include "core/traversal/timeline.h"

namespace sightline {

/// How many primitives a step takes in methods that order primitives, not cells.
inline constexpr std::uint32_t primitive_batch = 32;

namespace detail {

inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
}

/// Meets a primitive for the first time in this frame. False when the budget has no place for it: nothing changed.
template <int D>
bool meet_primitive(const Frame<D>& frame, State<D>& state, std::uint32_t primitive, bool cull) {
    if (state.primitive_frame[primitive] == state.frame) return true;
    const bool culled = cull && !shows(frame, primitive);
    const bool costs = !culled || frame.settings.culled_cost == CulledCost::charged;
    if (costs && state.spent >= frame.budget) return false;
    state.primitive_frame[primitive] = state.frame;
    state.touched.resize(state.touched_count);  // a recording's undone future, if any, is replaced
    state.touched.push_back(culled ? primitive | State<D>::culled_bit : primitive);
    ++state.touched_count;
    state.rendered_count += !culled;
    state.spent += costs;
    return true;
}

/// fig. 4, line 3: renders from `offset` on. True when the cell is done, false when the budget ended inside it.
template <int D>
bool project(const Frame<D>& frame, State<D>& state, std::uint32_t cell) {
    const auto primitives = frame.cells->primitives_of(cell);
    for (; state.offset < primitives.size(); ++state.offset)
        if (!meet_primitive(frame, state, primitives[state.offset], true)) return false;
    return true;
}

/// fig. 4, lines 6-10.
template <int D, typename Heuristic, typename Sink>
void add_neighbours(const Frame<D>& frame, State<D>& state, std::uint32_t cell, Sink& sink) {
    const double rho = state.mark(cell).key;
    for (const HalfFacet& half : frame.cells->facets_of(cell)) {
        const std::uint32_t n = half.neighbour;
        CellMark before;
        Rule rule = Rule::border;
        if (n != none) {
            before = state.mark(n);
            if (before.state == CellState::projected) {
                rule = Rule::projected;
            } else if (before.state == CellState::unseen) {
                rule = Rule::unseen;
            } else if (before.state == CellState::clean) {
                if (frame.settings.outside_view == OutsideView::unseen && !cell_in_view(*frame.cells, frame.view, n)) {
                    state.set_mark(n, {0, 0, CellState::unseen});
                    rule = Rule::marked_unseen;
                } else {
                    enqueue(state, n, Heuristic::template terms<D>(frame, cell, rho, half).key);
                    rule = Rule::enqueued;
                }
            } else {
                rule = Rule::kept;
                if constexpr (Heuristic::updates_enqueued) {
                    const double key = Heuristic::template terms<D>(frame, cell, rho, half).key;
                    const OnReenqueue on = frame.settings.on_reenqueue;
                    if (on == OnReenqueue::replace || (on == OnReenqueue::min && key < before.key) ||
                        (on == OnReenqueue::max && key > before.key)) {
                        enqueue(state, n, key);
                        rule = Rule::reenqueued;
                    }
                }
            }
        }
        if constexpr (Sink::enabled) sink.facet(before, rule);
    }
}

// The pops jump about in space, so that most of a step's time goes into waiting for memory, one row after the other.
// The three functions below ask for it ahead; they change nothing else.

/// Where the rows of the cell that is likely to be next begin.
template <int D>
void prefetch_row_begins(const Frame<D>& frame, const State<D>& state, std::uint32_t cell) {
    const std::uint32_t next = state.front.likely_next(cell);
    if (!frame.cells->cell_facet_begin.empty()) prefetch(&frame.cells->cell_facet_begin[next]);
    prefetch(&frame.cells->cell_primitive_begin[next]);
}

/// The rows themselves.
template <int D>
void prefetch_rows(const Frame<D>& frame, const State<D>& state, std::uint32_t cell) {
    const std::uint32_t next = state.front.likely_next(cell);
    prefetch(frame.cells->facets_of(next).data());
    prefetch(frame.cells->primitives_of(next).data());
}

/// What the rows of the popped cell point at.
template <int D>
void prefetch_step(const Frame<D>& frame, const State<D>& state, std::uint32_t cell) {
    const CellComplex<D>& cells = *frame.cells;
    for (const HalfFacet& half : cells.facets_of(cell)) {
        if (half.neighbour == none) continue;
        prefetch(&state.marks[half.neighbour]);
        prefetch(cells.corners_of(half.neighbour).data());
        prefetch(cells.points_of_facet(half.facet()).data());
    }
    for (const std::uint32_t primitive : cells.primitives_of(cell)) prefetch(&state.primitive_frame[primitive]);
}

/// Projects the popped or partly rendered cell and adds its neighbours, as far as the budget allows.
template <int D, typename Heuristic, typename Sink>
void go_on_with(const Frame<D>& frame, State<D>& state, std::uint32_t cell, Sink& sink) {
    const bool resumed = state.partial_cell == cell;
    const bool neighbours_first = frame.settings.neighbours_before_break == YesNo::yes;
    const bool done = project(frame, state, cell);
    // "no" is the papers' break: the budget ends the loop before the neighbours, even at the end of a cell.
    const bool broken = neighbours_first ? !done : state.spent >= frame.budget;
    if (neighbours_first ? !resumed : !broken) add_neighbours<D, Heuristic>(frame, state, cell, sink);
    state.partial_cell = broken ? cell : none;
    if (!broken) state.offset = 0;
}

}  // namespace detail

/// Starts a frame with the seed cells in the front.
template <int D, typename Heuristic>
void start_cells(const Frame<D>& frame, State<D>& state) {
    begin_frame(state, frame);
    for (const std::uint32_t seed : seed_cells(frame)) {
        if (state.seed == none) state.seed = seed;
        enqueue(state, seed, Heuristic::seed_key);
    }
}

/// One pop, or the rest of the cell that the budget left partly rendered. Stop::none when a step was made.
template <int D, typename Heuristic, typename Sink>
Stop step_cells(const Frame<D>& frame, State<D>& state, Sink& sink) {
    std::uint32_t cell = state.partial_cell;
    if (state.spent >= frame.budget) return Stop::budget;
    if (cell == none) {
        const Front::Entry* top = front_top(state);
        if (!top) return Stop::front_empty;
        cell = top->cell;
        state.front.pop();
        --state.front_size;
        CellMark mark = state.mark(cell);
        mark.state = CellState::projected;
        state.set_mark(cell, mark);
        ++state.step;
        detail::prefetch_step(frame, state, cell);
        detail::prefetch_row_begins(frame, state, cell);
        if constexpr (Sink::enabled) sink.popped(cell, front_top(state));
    }
    detail::go_on_with<D, Heuristic>(frame, state, cell, sink);
    detail::prefetch_rows(frame, state, cell);
    if constexpr (Sink::enabled) sink.finished(state);
    return Stop::none;
}

/// Starts a frame with the primitives in the order that Order::primitives(frame) gives.
template <int D, typename Order>
void start_primitives(const Frame<D>& frame, State<D>& state) {
    begin_frame(state, frame);
    state.order = Order::template primitives<D>(frame);
}

/// One batch of the order, or the rest of the batch that the budget cut.
template <int D, typename Order, typename Sink>
Stop step_primitives(const Frame<D>& frame, State<D>& state, Sink& sink) {
    if (state.offset >= state.order.size()) return Stop::front_empty;
    if (state.spent >= frame.budget) return Stop::budget;
    if (state.offset % primitive_batch == 0) {
        ++state.step;
        if constexpr (Sink::enabled) sink.popped(none, nullptr);
    }
    do {
        if (!detail::meet_primitive(frame, state, state.order[state.offset], Order::culls)) break;
        ++state.offset;
    } while (state.offset < state.order.size() && state.offset % primitive_batch != 0);
    if constexpr (Sink::enabled) sink.finished(state);
    return Stop::none;
}

}  // namespace sightline
