// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/cell_base.h"

#include <algorithm>

#include "core/base/hash.h"
#include "core/methods/cells/seed_cells.h"
#include "core/methods/cells/seen_before.h"

namespace sightline {

template <int D>
void CellBase<D>::begin_cells(double seed_key, Seeds seeds, bool from_seen) {
    marks_.begin(this->problem_.cells->cell_count());
    contents_ = CellContents<D>(this->problem_);
    in_view_.begin(*this->problem_.cells);
    front_.clear();
    front_is_stale_ = false;
    seeds_.clear();
    const auto add = [&](std::uint32_t seed) {
        if (marks_[seed].state != CellState::clean) return;
        seeds_.push_back(cell_item(seed));
        enqueue(seed, seed_key, false);
    };
    const std::vector<std::uint32_t> first = seed_cells(this->problem_, seeds);
    std::for_each(first.begin(), first.end(), add);
    if (!from_seen) return;
    const std::vector<std::uint32_t> seen = cells_seen_before(this->problem_);
    std::for_each(seen.begin(), seen.end(), add);
}

template <int D>
const Front::Entry* CellBase<D>::front_top() {
    if (front_is_stale_) {
        refill(front_, marks_);
        front_is_stale_ = false;
    }
    return front_.top([&](const Front::Entry& entry) { return marks_.is_enqueued(entry.id, entry.stamp); });
}

template <int D>
bool CellBase<D>::finished() const {
    if (in_rounds()) {
        if (cut_short()) return true;
        if (rounds_->done == 0) return false;
        for (std::uint32_t cell = 0; cell < marks_.size(); ++cell)
            if (may_be_seen(cell)) return false;
        return true;
    }
    return first_phase_ended();
}

/// The cell of a step: back into the front, or projected again.
template <int D>
void CellBase<D>::put_popped(const Step& step, Direction direction, const Counters& before) {
    Mark mark = marks_[step.item.id];
    mark.state = direction == Direction::back ? CellState::enqueued : CellState::projected;
    if (stamps_pops()) mark.stamp = direction == Direction::back ? step.stamp : before.next_stamp;
    marks_.set(step.item.id, mark);
}

template <int D>
bool CellBase<D>::move(Direction direction, const Step& step, std::span<Change> changes, const Counters& before) {
    const auto put = [&](Change& change) {
        const bool forward = direction == Direction::forward;
        if (Rule{change.rule} == Rule::tile_off) return rounds_->put_tile(change.id, step.item.id, forward);
        exchange(marks_, change);
        if (!rounds_) return;
        if (Rule{change.rule} == Rule::tested_hidden) rounds_->hidden[change.id] = forward;
        if (Rule{change.rule} == Rule::projected_now) rounds_->round_of[change.id] = forward ? step.item.id : 0;
        if (Rule{change.rule} == Rule::lost) rounds_->put_lost(change.id, step.item.id, forward);
    };
    const bool round = step.item.kind == Kind::round;
    if (direction == Direction::back) {
        // The last first: a cell may be reached through several facets.
        std::for_each(changes.rbegin(), changes.rend(), put);
        if (round)
            --rounds_->done;
        else if (step.item)
            put_popped(step, direction, before);
        if (rounds_) rounds_->screen.forget();
    } else {
        if (round)
            ++rounds_->done;
        else if (step.item)
            put_popped(step, direction, before);
        std::for_each(changes.begin(), changes.end(), put);
    }
    this->move_met(direction, step, before);
    front_is_stale_ = true;
    return true;
}

template <int D>
std::size_t CellBase<D>::facets_looked_across(const Step& step) const {
    if (step.item.kind != Kind::cell) return 0;
    if (step.item.id == rewound_cell_) return rewound_facets_;
    const bool neighbours_first = parameters_.neighbours_before_break == YesNo::yes;
    if (!neighbours_first && step.after.partial_cell == step.item.id) return 0;
    return this->problem_.cells->facets_of(step.item.id).size();
}

template <int D>
std::uint32_t CellBase<D>::substeps(const Step& step, std::span<const Change> changes) const {
    if (step.item.kind == Kind::round)
        return rounds_->form.first_test_substep() + static_cast<std::uint32_t>(tests_of(changes).size());
    return first_facet_substep + static_cast<std::uint32_t>(facets_looked_across(step));
}

template <int D>
void CellBase<D>::rewind_to(Step& step, std::vector<Change>& changes, const Counters& before, std::uint32_t substep) {
    if (step.item.kind == Kind::round) {
        rewind_round(changes, before, substep);
        step.after = this->counters_;
        return;
    }
    if (!step.item) {  // a batch of what waited
        this->drawn_.take_back(before.touched_count, this->counters_.touched_count);
        step.after = this->counters_ = before;
        front_is_stale_ = true;
        return;
    }
    const auto facets = this->problem_.cells->facets_of(step.item.id);
    rewound_cell_ = step.item.id;
    rewound_facets_ = substep < first_facet_substep ? 0 : substep - first_facet_substep + 1;
    const auto done = facets.first(rewound_facets_);
    while (!changes.empty() && std::none_of(done.begin(), done.end(), [&](const HalfFacet& half) {
        return half.facet() == changes.back().via;
    })) {
        marks_.set(changes.back().id, changes.back().mark());
        changes.pop_back();
    }
    Counters& counters = this->counters_;
    counters.front_size = before.front_size - 1;
    counters.next_stamp = before.next_stamp + stamps_pops();
    for (const Change& change : changes) {
        const Rule rule{change.rule};
        counters.front_size += rule == Rule::enqueued;
        counters.next_stamp += rule == Rule::enqueued || rule == Rule::reenqueued;
    }
    if (substep == 0) {
        this->drawn_.take_back(before.touched_count, counters.touched_count);
        counters.touched_count = before.touched_count;
        counters.rendered_count = before.rendered_count;
        counters.spent = before.spent;
        counters.partial_cell = before.partial_cell;
        counters.offset = before.offset;
    }
    front_is_stale_ = true;
    step.after = counters;
}

template <int D>
std::size_t CellBase<D>::memory_bytes() const {
    return marks_.memory_bytes() + in_view_.memory_bytes() + this->drawn_.memory_bytes() +
           (rounds_ ? 5 * std::size_t{marks_.size()} + 4 * rounds_->last_read.size() : 0);
}

template <int D>
std::uint64_t CellBase<D>::hash() const {
    Hash hash;
    for (std::uint32_t cell = 0; cell < marks_.size(); ++cell) add_mark(hash, marks_[cell]);
    if (rounds_) {
        hash.add(rounds_->done);
        for (std::uint32_t cell = 0; cell < marks_.size(); ++cell)
            hash.add(std::uint64_t{rounds_->round_of[cell]} << 1 | rounds_->hidden[cell]);
        for (const std::uint32_t round : rounds_->last_read) hash.add(round);
    }
    add_run(hash, *this);
    return hash.value();
}

template <int D>
std::vector<std::pair<Item, Mark>> CellBase<D>::front() const {
    return waiting_items(marks_, Kind::cell);
}

template <int D>
std::vector<Considered> CellBase<D>::considered(const Step& step, std::span<const Change> changes, int digits) const {
    if (step.item.kind == Kind::round) return tests_of(changes);
    std::vector<Considered> all;
    if (step.item.kind != Kind::cell) return all;
    const double key = marks_[step.item.id].key;
    for (const HalfFacet& half : this->problem_.cells->facets_of(step.item.id).first(facets_looked_across(step))) {
        Considered& c = all.emplace_back();
        c.from = step.item;
        c.item = cell_item(half.neighbour);
        c.via = facet_item(half.facet());
        Rule rule = Rule::border;
        if (!changes.empty() && changes.front().via == half.facet()) {
            rule = Rule{changes.front().rule};
            c.effect = rule == Rule::kept ? Effect::kept : Effect::changed;
            c.before = changes.front().mark();
            if (rule != Rule::marked_unseen) c.key = explain_key(step.item.id, key, half, digits);
            changes = changes.subspan(1);
        } else if (half.neighbour != none) {
            c.before = marks_[half.neighbour];
            rule = c.before.state == CellState::unseen ? Rule::unseen : Rule::projected;
        }
        c.rule = static_cast<std::uint8_t>(rule);
        c.words = rule_words(c.rule);
    }
    return all;
}

template class CellBase<2>;
template class CellBase<3>;

}  // namespace sightline
