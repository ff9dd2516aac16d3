// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/substep.h"

namespace sightline {

namespace {

constexpr std::uint32_t pop = 0, first_facet = first_facet_substep;

/// The counters before a step: those after the one before it, or at step 1 those of the start.
Counters counters_before(const Timeline& timeline, std::uint32_t step) {
    if (step > 1) return timeline.steps[step - 2];
    Counters start;
    start.front_size = start.next_stamp = timeline.seed_count;
    return start;
}

}  // namespace

template <int D>
std::uint32_t substep_count(const Session<D>& session, std::uint32_t step) {
    return first_facet + static_cast<std::uint32_t>(session.timeline().facets_of(step).size());
}

template <int D>
Session<D> Session<D>::in_the_middle(std::uint32_t substep) const {
    Session copy = *this;
    const std::uint32_t step = position();
    if (step == 0 || substep + 1 >= substep_count(*this, step)) return copy;
    State<D>& state = copy.state_;
    Timeline& timeline = copy.timeline_;
    StepRecord& record = timeline.steps[step - 1];
    const Counters before = counters_before(timeline, step);

    // A later facet may lead to the same cell as an earlier one: backwards the mark before the earlier one wins.
    const auto records = timeline_.facets_of(step);
    const std::size_t done = substep < first_facet ? 0 : substep - first_facet + 1;
    for (std::size_t i = records.size(); i-- > done;)
        if (records[i].rule != Rule::border)
            state.set_mark(cells_->facets_of(record.cell)[i].neighbour,
                           {records[i].key, records[i].stamp, records[i].state});
    if (record.cell != none) {
        state.front_size = before.front_size - 1;
        state.next_stamp = before.next_stamp;
        for (const FacetRecord& facet : records.first(done)) {
            state.front_size += facet.rule == Rule::enqueued;
            state.next_stamp += facet.rule == Rule::enqueued || facet.rule == Rule::reenqueued;
        }
    }
    if (substep == pop) {
        for (std::uint32_t i = before.touched_count; i < state.touched_count; ++i)
            state.primitive_frame[state.touched[i] & ~State<D>::culled_bit] = 0;
        state.touched_count = before.touched_count;
        state.rendered_count = before.rendered_count;
        state.spent = before.spent;
        state.partial_cell = before.partial_cell;
        state.offset = before.offset;
    }
    state.front_is_stale = true;

    // The record tells the same, so that words about the step do not run ahead.
    static_cast<Counters&>(record) = state;
    const auto drop = static_cast<std::uint32_t>(records.size() - done);
    const auto kept_end = timeline.facets.begin() + static_cast<std::ptrdiff_t>(record.first_facet + done);
    timeline.facets.erase(kept_end, kept_end + drop);
    for (std::size_t later = step; later < timeline.steps.size(); ++later) timeline.steps[later].first_facet -= drop;
    return copy;
}

template std::uint32_t substep_count<2>(const Session<2>&, std::uint32_t);
template std::uint32_t substep_count<3>(const Session<3>&, std::uint32_t);
template Session<2> Session<2>::in_the_middle(std::uint32_t) const;
template Session<3> Session<3>::in_the_middle(std::uint32_t) const;

}  // namespace sightline
