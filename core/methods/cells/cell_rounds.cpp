// A run of cells that is completed in rounds: what the gem calls find_visible_front and conservative_finish, each cell
// of the front tested by itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/text.h"
#include "core/methods/cells/cell_base.h"
#include "core/methods/cells/seed_cells.h"

namespace sightline {

namespace {

constexpr auto as_rule = [](const Change& change) { return Rule{change.rule}; };

bool is_test(const Change& change) {
    return as_rule(change) == Rule::tested_seen || as_rule(change) == Rule::tested_hidden;
}

}  // namespace

template <int D>
void CellBase<D>::complete_in_rounds(bool only_winners) {
    rounds_.emplace();
    rounds_->only_winners = only_winners;
    rounds_->begin(marks_.size());
}

template <int D>
bool CellBase<D>::first_phase_ended() const {
    const Counters& counters = this->counters_;
    return counters.spent >= this->problem_.budget || (counters.front_size == 0 && counters.partial_cell == none);
}

template <int D>
bool CellBase<D>::may_be_seen(std::uint32_t cell) const {
    return marks_[cell].state == CellState::enqueued && !rounds_->hidden[cell];
}

/// What the first phase left behind: the rest of the last cell and, where they are not there yet, its neighbours; the
/// other cells that an eye outside looks into first, and primitives that lie in no cell.
template <int D>
void CellBase<D>::begin_rounds(Recorder* recorder) {
    const CellComplex<D>& cells = *this->problem_.cells;
    if (this->counters_.partial_cell != none) finish_partial(recorder);
    Problem<D> all = this->problem_;
    all.parameters.set(seeds_row(), word(Seeds::hull));
    for (const std::uint32_t seed : seed_cells(all)) {
        const Mark before = marks_[seed];
        if (before.state != CellState::clean) continue;
        if (recorder) recorder->changed(cell_item(seed), before, static_cast<std::uint8_t>(Rule::enqueued));
        enqueue(seed, 0, false);
    }
    if (cells.unassigned == 0) return;
    std::vector<std::uint8_t> in_a_cell(this->problem_.primitives().size());
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const std::uint32_t primitive : cells.primitives_of(cell)) in_a_cell[primitive] = 1;
    for (std::uint32_t primitive = 0; primitive < in_a_cell.size(); ++primitive)
        if (!in_a_cell[primitive]) this->meet(primitive, true);
}

template <int D>
Stop CellBase<D>::make_round(Recorder* recorder) {
    if (finished()) return Stop::complete;
    const std::uint32_t budget = std::exchange(this->problem_.budget, none);
    ++this->steps_;
    const std::uint32_t number = ++rounds_->done;
    if (recorder) recorder->popped({number, Kind::round}, {});
    if (number == 1) begin_rounds(recorder);
    Screen<D>& screen = rounds_->screen;
    screen.show(this->problem_, this->met(), this->counters_.touched_count);
    std::vector<std::uint32_t> seen;
    for (const auto& [item, mark] : front()) {
        if (rounds_->hidden[item.id]) continue;
        const auto pixel = screen.seen_at(this->problem_, item.id);
        if (pixel)
            seen.push_back(item.id);
        else
            rounds_->hidden[item.id] = 1;
        if (recorder)
            recorder->changed(item, mark, static_cast<std::uint8_t>(pixel ? Rule::tested_seen : Rule::tested_hidden),
                              pixel.value_or(none));
    }
    // All at once, since threads help where there is much to draw.
    std::vector<std::uint32_t> candidates, ends;
    std::span<const std::uint8_t> won;
    if (rounds_->only_winners) {
        for (const std::uint32_t cell : seen) {
            for (const std::uint32_t primitive : this->problem_.cells->primitives_of(cell))
                if (!this->drawn_.has(primitive)) candidates.push_back(primitive);
            ends.push_back(static_cast<std::uint32_t>(candidates.size()));
        }
        won = screen.draw(candidates);
    }
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        rounds_->round_of[seen[i]] = number;
        rounds_->winners.clear();
        for (; rounds_->only_winners && next < ends[i]; ++next)
            if (won[next]) rounds_->winners.push_back(candidates[next]);
        project_now(seen[i], recorder);
    }
    if (rounds_->only_winners) screen.met(this->counters_.touched_count);
    this->problem_.budget = budget;
    if (recorder) recorder->finished(this->counters_);
    return Stop::none;
}

/// Back to before the projections, with the tests up to the substep.
template <int D>
void CellBase<D>::rewind_round(std::vector<Change>& changes, const Counters& before, std::uint32_t substep) {
    const std::uint32_t tests = substep < first_test_substep ? 0 : substep - first_test_substep + 1;
    std::size_t kept = 0;
    for (std::uint32_t met = 0; kept < changes.size() && as_rule(changes[kept]) != Rule::projected_now; ++kept)
        if (is_test(changes[kept]) && met++ == tests) break;
    for (; changes.size() > kept; changes.pop_back()) {
        const Change& last = changes.back();
        marks_.set(last.id, last.mark());
        if (as_rule(last) == Rule::tested_hidden) rounds_->hidden[last.id] = 0;
        if (as_rule(last) == Rule::projected_now) rounds_->round_of[last.id] = 0;
    }
    const std::uint32_t met = this->counters_.touched_count;
    std::uint32_t added = 0, stamps = 0;
    for (const Change& change : changes) {
        added += as_rule(change) == Rule::enqueued;
        stamps += as_rule(change) == Rule::enqueued || as_rule(change) == Rule::reenqueued;
    }
    this->counters_ = before;
    this->counters_.front_size += added;
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
        test.effect = as_rule(change) == Rule::tested_seen ? Effect::changed : Effect::kept;
        test.before = change.mark();
    }
    return tests;
}

/// The second phase, under the lines of the first.
template <int D>
void CellBase<D>::add_round_lines(std::vector<CodeLine>& lines, const CodePlace& at, bool in_round) const {
    const bool here = in_round || (!at.in_step() && in_rounds());
    if (here)
        for (CodeLine& line : lines) line.lit = false;
    const auto tests = in_round ? tests_of(at.changes) : std::vector<Considered>{};
    const std::uint32_t substep = in_round ? *at.substep : 0;
    const std::size_t test = substep - first_test_substep;
    const auto add = [&](std::string text, int indent, bool lit, std::string_view source) -> CodeLine& {
        lines.push_back({std::move(text), indent, lit, {}, std::string(source)});
        return lines.back();
    };
    CodeLine& loop =
        add("then, until no cell of the front can be seen:", 0, here && !in_round, "gem, conservative_finish");
    if (loop.lit)
        loop.values = finished() ? "none can: nothing visible is left"
                                 : "round " + std::to_string(rounds_->done + 1) + " is next";
    add("draw what is rendered into a depth image", 1, in_round && substep < first_test_substep,
        "gem, find_visible_front");
    CodeLine& line = add("for each cell of the front: does a pixel of it lie before that image?", 1,
                         in_round && substep >= first_test_substep && test < tests.size(), "gem, find_visible_front");
    if (line.lit)
        line.values = item_name(tests[test].item) +
                      (Rule{tests[test].rule} == Rule::tested_seen ? ": yes" : ": no, it stays hidden");
    add("project those that can be seen, and add their neighbours", 1,
        in_round && substep >= first_test_substep && test >= tests.size(), "gem, conservative_finish");
}

template <int D>
Misses CellBase<D>::misses() const {
    return rounds_ && finished() ? Misses::none_at_this_resolution : Misses::may;
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

template <int D>
std::string CellBase<D>::popped_words(const Step& step) const {
    return step.item.kind == Kind::round ? "round " + std::to_string(step.item.id) : Run<D>::popped_words(step);
}

template <int D>
Verdict CellBase<D>::why_waiting(const Item& item) const {
    if (!rounds_ || item.kind != Kind::cell || !rounds_->hidden[item.id]) return {};
    Screen<D> screen;
    screen.show(this->problem_, this->met(), this->counters_.touched_count);
    const SeenPart sight = screen.part_of(this->problem_, item.id);
    return {"hidden", "it is hidden: its " + std::to_string(sight.pixels) +
                          (sight.pixels == 1 ? " pixel lies" : " pixels lie") + " behind " +
                          some_of(D == 2 ? "segment" : "triangle", sight.hidden_by, most_hiders)};
}

#define SIGHTLINE_INSTANTIATE(D)                                                                      \
    template void CellBase<D>::complete_in_rounds(bool);                                              \
    template bool CellBase<D>::first_phase_ended() const;                                             \
    template bool CellBase<D>::may_be_seen(std::uint32_t) const;                                      \
    template void CellBase<D>::begin_rounds(Recorder*);                                               \
    template Stop CellBase<D>::make_round(Recorder*);                                                 \
    template void CellBase<D>::rewind_round(std::vector<Change>&, const Counters&, std::uint32_t);    \
    template void CellBase<D>::add_round_lines(std::vector<CodeLine>&, const CodePlace&, bool) const; \
    template std::vector<Considered> CellBase<D>::tests_of(std::span<const Change>) const;            \
    template Misses CellBase<D>::misses() const;                                                      \
    template std::uint64_t CellBase<D>::tests() const;                                                \
    template std::string CellBase<D>::popped_words(const Step&) const;                                \
    template Verdict CellBase<D>::why_waiting(const Item&) const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
