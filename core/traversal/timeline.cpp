// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/traversal/timeline.h"

#include <utility>

namespace sightline {

namespace {

/// Exchanges the neighbours' marks with those in the records.
template <int D>
void exchange(State<D>& state, const CellComplex<D>& cells, std::uint32_t cell, std::span<FacetRecord> records) {
    const auto facets = cells.facets_of(cell);
    for (std::size_t i = 0; i < records.size(); ++i) {  // none where the budget ended the step before the neighbours
        FacetRecord& record = records[i];
        if (record.rule == Rule::border) continue;
        const CellMark here = state.mark(facets[i].neighbour);
        state.set_mark(facets[i].neighbour, {record.key, record.stamp, record.state});
        record = {here.key, here.stamp, here.state, record.rule};
    }
}

template <int D>
void set_cell_state(State<D>& state, std::uint32_t cell, CellState to) {
    CellMark mark = state.mark(cell);
    mark.state = to;
    state.set_mark(cell, mark);
}

template <int D>
void set_counters(State<D>& state, const Counters& counters) {
    static_cast<Counters&>(state) = counters;
    state.front_is_stale = true;
}

std::span<FacetRecord> records_of(Timeline& timeline, std::uint32_t step) {
    const auto records = timeline.facets_of(step);
    return std::span(timeline.facets)
        .subspan(static_cast<std::size_t>(records.data() - timeline.facets.data()), records.size());
}

}  // namespace

template <int D>
void undo_step(const Frame<D>& frame, State<D>& state, Timeline& timeline) {
    const StepRecord& record = timeline.steps[state.step - 1];
    if (record.cell != none) {
        exchange(state, *frame.cells, record.cell, records_of(timeline, state.step));
        set_cell_state(state, record.cell, CellState::enqueued);
    }
    for (std::uint32_t i = timeline.touched_before(state.step); i < state.touched_count; ++i)
        state.primitive_frame[state.touched[i] & ~State<D>::culled_bit] = 0;
    --state.step;
    if (state.step > 0) {
        set_counters(state, timeline.steps[state.step - 1]);
        return;
    }
    // At the start only the seeds are in the front, stamped from 0.
    Counters start;
    start.front_size = start.next_stamp = timeline.seed_count;
    set_counters(state, start);
}

template <int D>
void redo_step(const Frame<D>& frame, State<D>& state, Timeline& timeline) {
    const StepRecord& record = timeline.steps[state.step];
    ++state.step;
    if (record.cell != none) {
        set_cell_state(state, record.cell, CellState::projected);
        exchange(state, *frame.cells, record.cell, records_of(timeline, state.step));
    }
    for (std::uint32_t i = state.touched_count; i < record.touched_count; ++i)
        state.primitive_frame[state.touched[i] & ~State<D>::culled_bit] = state.frame;
    set_counters(state, record);
}

template void undo_step<2>(const Frame<2>&, State<2>&, Timeline&);
template void undo_step<3>(const Frame<3>&, State<3>&, Timeline&);
template void redo_step<2>(const Frame<2>&, State<2>&, Timeline&);
template void redo_step<3>(const Frame<3>&, State<3>&, Timeline&);

}  // namespace sightline
