// A run of cells that is completed in rounds: what the gem calls find_visible_front and conservative_finish.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/methods/cells/cell_base.h"
#include "core/methods/cells/front_image.h"
#include "core/methods/cells/seed_cells.h"
#include "core/space/outside.h"

namespace sightline {

namespace {

constexpr auto as_rule = [](const Change& change) { return Rule{change.rule}; };

}  // namespace

template <int D>
void CellBase<D>::complete_in_rounds(const RoundForm& form) {
    this->problem_.budget = std::min(this->problem_.budget, form.total);
    rounds_.emplace();
    rounds_->begin(form, marks_.size(), screen_tiles(this->problem_));
}

template <int D>
bool CellBase<D>::first_phase_ended() const {
    const Counters& counters = this->counters_;
    return counters.spent >= this->problem_.budget ||
           (counters.front_size == 0 && counters.partial_cell == none && !more_waits());
}

template <int D>
bool CellBase<D>::may_be_seen(std::uint32_t cell) const {
    return marks_[cell].state == CellState::enqueued && !rounds_->hidden[cell];
}

/// What the first phase left behind: the rest of the last cell and, where they are not there yet, its neighbours; the
/// other cells that an eye outside looks into first, and what no cell holds whole.
template <int D>
void CellBase<D>::begin_rounds(Recorder* recorder) {
    const CellComplex<D>& cells = *this->problem_.cells;
    if (this->counters_.partial_cell != none) finish_partial(recorder);
    for (const std::uint32_t seed : seed_cells(this->problem_, Seeds::hull)) {
        const Mark before = marks_[seed];
        if (before.state != CellState::clean) continue;
        if (recorder) recorder->changed(cell_item(seed), before, static_cast<std::uint8_t>(Rule::enqueued));
        enqueue(seed, 0, false);
    }
    // What no cell holds whole may be seen where no cell lies: nothing would test it there.
    for (const std::uint32_t primitive : reaching_outside<D>(cells, this->problem_.primitives()))
        this->meet(primitive, true);
}

template <int D>
Stop CellBase<D>::make_round(Recorder* recorder) {
    if (finished()) return cut_short() ? Stop::budget : Stop::complete;
    const std::uint32_t budget = std::exchange(this->problem_.budget, rounds_->form.total);
    ++this->steps_;
    const std::uint32_t number = ++rounds_->done;
    if (recorder) recorder->popped({number, Kind::round}, {});
    if (number == 1) {
        rounds_->met_before = this->counters_.touched_count;
        begin_rounds(recorder);
    }
    rounds_->screen.show(this->problem_, this->met(), this->counters_.touched_count);
    project_seen(rounds_->form.test == FrontTest::item ? test_in_one_image(recorder) : test_each(recorder), recorder);
    this->problem_.budget = budget;
    if (recorder) recorder->finished(this->counters_);
    return Stop::none;
}

/// Those that can be seen.
template <int D>
std::vector<std::uint32_t> CellBase<D>::test_each(Recorder* recorder) {
    std::vector<std::uint32_t> seen;
    for (const auto& [item, mark] : front()) {
        if (rounds_->hidden[item.id]) continue;
        const auto pixel = rounds_->screen.seen_at(this->problem_, item.id);
        if (pixel)
            seen.push_back(item.id);
        else
            rounds_->hidden[item.id] = 1;
        if (recorder)
            recorder->changed(item, mark, static_cast<std::uint8_t>(pixel ? Rule::tested_seen : Rule::tested_hidden),
                              pixel.value_or(none));
    }
    return seen;
}

template <int D>
void CellBase<D>::project_seen(const std::vector<std::uint32_t>& seen, Recorder* recorder) {
    // All at once, since threads help where there is much to draw.
    const bool only_winners = rounds_->form.only_winners;
    std::vector<std::uint32_t> candidates, ends;
    std::span<const std::uint8_t> won;
    if (only_winners) {
        for (const std::uint32_t cell : seen) {
            for (const std::uint32_t primitive : this->problem_.cells->primitives_of(cell))
                if (!this->drawn_.has(primitive)) candidates.push_back(primitive);
            ends.push_back(static_cast<std::uint32_t>(candidates.size()));
        }
        won = rounds_->screen.draw(candidates);
    }
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < seen.size() && !cut_short(); ++i) {
        rounds_->round_of[seen[i]] = rounds_->done;
        rounds_->winners.clear();
        for (; only_winners && next < ends[i]; ++next)
            if (won[next]) rounds_->winners.push_back(candidates[next]);
        project_now(seen[i], recorder);
    }
    if (cut_short())
        rounds_->screen.forget();  // it may show what was not met any more
    else if (only_winners)
        rounds_->screen.met(this->counters_.touched_count);
}

/// Back to before the projections, with the tests up to the substep.
template <int D>
void CellBase<D>::rewind_round(std::vector<Change>& changes, const Counters& before, std::uint32_t substep) {
    const std::uint32_t first = rounds_->form.first_test_substep(), tests = substep < first ? 0 : substep - first + 1;
    std::size_t kept = 0;
    for (std::uint32_t met = 0; kept < changes.size() && as_rule(changes[kept]) != Rule::projected_now; ++kept)
        if (is_test(changes[kept]) && met++ == tests) break;
    for (; changes.size() > kept; changes.pop_back()) {
        const Change& last = changes.back();
        if (as_rule(last) == Rule::tile_off) {
            rounds_->put_tile(last.id, rounds_->done, false);
            continue;
        }
        marks_.set(last.id, last.mark());
        if (as_rule(last) == Rule::lost) rounds_->put_lost(last.id, rounds_->done, false);
        if (as_rule(last) == Rule::tested_hidden) rounds_->hidden[last.id] = 0;
        if (as_rule(last) == Rule::projected_now) rounds_->round_of[last.id] = 0;
    }
    const std::uint32_t met = this->counters_.touched_count;
    std::uint32_t added = 0, taken = 0, stamps = 0;
    for (const Change& change : changes) {
        added += as_rule(change) == Rule::enqueued;
        taken += as_rule(change) == Rule::lost;
        stamps += as_rule(change) == Rule::enqueued || as_rule(change) == Rule::reenqueued;
    }
    this->counters_ = before;
    this->counters_.front_size += added - taken;
    this->counters_.next_stamp += stamps;
    this->drawn_.take_back(before.touched_count, met);
    front_is_stale_ = true;
}

template <int D>
std::vector<Considered> CellBase<D>::tests_of(std::span<const Change> changes) const {
    std::vector<Considered> tests;
    for (const Change& change : changes) {
        if (!is_test(change)) continue;
        Considered& test = tests.emplace_back();
        test.item = change.item();
        test.rule = change.rule;
        test.words = rule_words(change.rule);
        const bool stays = as_rule(change) == Rule::tested_hidden || as_rule(change) == Rule::tested_without;
        test.effect = stays ? Effect::kept : Effect::changed;
        test.before = change.mark();
    }
    return tests;
}

template <int D>
Misses CellBase<D>::misses() const {
    const bool complete = rounds_ && !rounds_->form.printed() && !cut_short() && finished();
    return complete ? Misses::none_at_this_resolution : Misses::may;
}

/// A cell that is seen is projected in the same round, and one that is hidden is never asked again.
template <int D>
std::uint64_t CellBase<D>::tests() const {
    if (!rounds_ || rounds_->done == 0) return 0;
    std::uint64_t count = 0;
    for (std::size_t cell = 0; cell < rounds_->hidden.size(); ++cell)
        count += (rounds_->hidden[cell] != 0) + (rounds_->round_of[cell] != 0);
    return count;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                   \
    template void CellBase<D>::complete_in_rounds(const RoundForm&);                               \
    template bool CellBase<D>::first_phase_ended() const;                                          \
    template bool CellBase<D>::may_be_seen(std::uint32_t) const;                                   \
    template void CellBase<D>::begin_rounds(Recorder*);                                            \
    template std::vector<std::uint32_t> CellBase<D>::test_each(Recorder*);                         \
    template void CellBase<D>::project_seen(const std::vector<std::uint32_t>&, Recorder*);         \
    template Stop CellBase<D>::make_round(Recorder*);                                              \
    template void CellBase<D>::rewind_round(std::vector<Change>&, const Counters&, std::uint32_t); \
    template std::vector<Considered> CellBase<D>::tests_of(std::span<const Change>) const;         \
    template Misses CellBase<D>::misses() const;                                                   \
    template std::uint64_t CellBase<D>::tests() const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
