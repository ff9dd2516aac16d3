// The state of a traversal of cells, and all that does not depend on how keys are computed: undo, substeps, what a step
// looked at.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_parameters.h"
#include "core/methods/cells/cell_rules.h"
#include "core/methods/cells/rounds.h"
#include "core/run/cell_contents.h"
#include "core/run/front.h"
#include "core/run/marks.h"
#include "core/run/run.h"
#include "core/space/cell_in_view.h"

namespace sightline {

/// Substeps of a step: 0 takes the cell out of the front, 1 renders its primitives, 2 + i looks across its facet i.
inline constexpr std::uint32_t first_facet_substep = 2;

template <int D>
class CellBase : public Run<D> {
public:
    using Run<D>::mark;

    bool finished() const override;
    bool undoes_by_marks() const override { return true; }
    std::uint32_t met_before_completing() const override {
        return rounds_ && rounds_->done > 0 ? rounds_->met_before : none;
    }
    std::vector<ReadTile> tiles() const override;
    std::uint64_t tests() const override;
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override;
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::size_t memory_bytes() const override;

    std::uint64_t hash() const override;
    Mark mark(const Item& item) const override { return item.kind == Kind::cell ? marks_[item.id] : Mark{}; }
    std::vector<std::pair<Item, Mark>> front() const override;
    std::span<const Item> seeds() const override { return seeds_; }

    std::string_view rule_words(std::uint8_t rule) const override { return sightline::rule_words[rule]; }
    std::vector<Considered> considered(const Step&, std::span<const Change>, int digits) const override;
    Verdict why_not(const Item&) const override;
    Verdict why_waiting(const Item&) const override;
    Misses misses() const override;
    std::string popped_words(const Step& step) const override;

    /// From the end of the budget on the run goes on in rounds until nothing visible is left (cplp/cplp.h). To be
    /// called before the first step.
    void complete_in_rounds(const RoundForm& form);
    /// Of ids, by a round: of the tiles that it reads, or of the whole image. Nothing where it draws no ids.
    std::optional<double> bytes_read(const Item& round, bool whole_image) const;
    std::vector<CodeLine> code(const CodePlace&) const override;

protected:
    explicit CellBase(const Problem<D>& problem) : Run<D>(problem), parameters_(problem.parameters) {}
    CellBase(const CellBase&) = default;

    /// Empties all and puts the seed cells into the front; `from_seen`: cells_seen_before() behind them.
    void begin_cells(double seed_key, Seeds seeds, bool from_seen);
    /// In the loop over neighbours, so inline. `was_enqueued`: the cell is in the front already.
    void enqueue(std::uint32_t cell, double key, bool was_enqueued) {
        Counters& counters = this->counters_;
        counters.front_size += !was_enqueued;
        marks_.set(cell, {key, counters.next_stamp, CellState::enqueued});
        front_.push({key, counters.next_stamp, cell});
        ++counters.next_stamp;
    }
    /// The first entry of the front, or nullptr when it is empty. Rebuilds the front from the marks after an undo.
    const Front::Entry* front_top();

    /// The key that a cell `a` with key `key_a` gives to the cell behind its facet.
    virtual KeyExplanation explain_key(std::uint32_t a, double key_a, const HalfFacet& half, int digits) const = 0;
    /// What happens to a cell in the front that is reached again.
    virtual OnReenqueue reenqueue_rule() const = 0;
    /// The lines below "key(n, c): …"; the first line says what the key is. `explained`: of the facet at hand.
    virtual void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const = 0;

    /// Projects a cell that waits in the front, whatever its place, and adds its neighbours.
    virtual void project_now(std::uint32_t cell, Recorder* recorder) = 0;
    /// Whether a pop gives its cell a new stamp, so that stamps tell which of two cells was projected first.
    virtual bool stamps_pops() const { return false; }
    /// What a step does with what its cell holds, as a line of code.
    virtual std::string_view project_line() const = 0;
    /// Whether primitives of projected cells wait to be rendered.
    virtual bool more_waits() const { return false; }
    /// Renders the rest of the cell that the budget left partly rendered, and adds its neighbours where they are
    /// pending.
    virtual void finish_partial(Recorder* recorder) = 0;
    /// The budget has ended, or the front is empty: a round, where the run goes on in rounds.
    bool in_rounds() const { return rounds_ && (rounds_->done > 0 || first_phase_ended()); }
    Stop make_round(Recorder* recorder);

    CellParameters parameters_;
    Marks marks_;
    CellContents<D> contents_;
    mutable CellsInView<D> in_view_;  ///< a cache
    Front front_;
    bool front_is_stale_ = false;  ///< marks were put back by an undo: rebuild the front before using it
    std::vector<Item> seeds_;
    std::optional<Rounds<D>> rounds_;

private:
    bool first_phase_ended() const;
    /// Both phases together have spent what they may.
    bool cut_short() const { return rounds_ && this->counters_.spent >= rounds_->form.total; }
    std::vector<std::uint32_t> test_each(Recorder* recorder);
    std::vector<std::uint32_t> test_in_one_image(Recorder* recorder);
    void project_seen(const std::vector<std::uint32_t>& seen, Recorder* recorder);
    Verdict why_lost(std::uint32_t cell) const;
    bool may_be_seen(std::uint32_t cell) const;
    void begin_rounds(Recorder* recorder);
    void rewind_round(std::vector<Change>& changes, const Counters& before, std::uint32_t substep);
    void add_round_lines(std::vector<CodeLine>& lines, const CodePlace& at, bool in_round) const;
    std::vector<Considered> tests_of(std::span<const Change> changes) const;
    void put_popped(const Step& step, Direction direction, const Counters& before);
    Verdict why_clean(std::uint32_t cell) const;
    /// Facets of the popped cell that the step looked across, from the first on.
    std::size_t facets_looked_across(const Step& step) const;

    std::uint32_t rewound_cell_ = none;  ///< the cell of the step that rewind_to cut, and how many of its facets
    std::size_t rewound_facets_ = 0;     ///< the step had looked across there
};

extern template class CellBase<2>;
extern template class CellBase<3>;

}  // namespace sightline
