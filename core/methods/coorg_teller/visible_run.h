// Algorithm Visible of Coorg and Teller: down a tree of boxes with the occluders that may hide a part of each box.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/box_states.h"
#include "core/run/marks.h"
#include "core/run/method.h"

namespace sightline {

/// Change::rule.
enum class VisibleRule : std::uint8_t {
    waits,      ///< a child of the popped box
    outside,    ///< the popped box lies outside the view: switched off
    invisible,  ///< occluders hide it
    opened,     ///< PARTIAL: its children are tested against the occluders that hide a part of it
    leaf,       ///< PARTIAL and a leaf: drawn
    gathered,   ///< VISIBLE and all in view: drawn whole
    looked_at,  ///< VISIBLE and partly in view: its children are tested against the view only
};
inline constexpr auto visible_rule_words = std::to_array<std::string_view>(
    {"waits", "outside the view", "INVISIBLE", "PARTIAL: opened", "PARTIAL, a leaf: drawn", "VISIBLE: drawn whole",
     "VISIBLE: its parts in view are drawn"});

/// Its items are boxes; their keys are their places in depth-first order. A leaf of which the budget left something is
/// Counters::partial_cell.
template <int D>
class VisibleRun final : public Run<D> {
public:
    using Run<D>::mark;

    VisibleRun(const Problem<D>& problem, OccluderKind kind);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    bool undoes_by_marks() const override { return true; }
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override { return by_change_ ? 1 : 2; }
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<VisibleRun>(*this); }
    std::size_t memory_bytes() const override { return marks_.memory_bytes() + this->drawn_.memory_bytes(); }
    std::uint64_t hash() const override;
    Mark mark(const Item& item) const override { return item.kind == Kind::node ? marks_[item.id] : Mark{}; }
    std::vector<std::pair<Item, Mark>> front() const override { return waiting_items(marks_, Kind::node); }
    Misses misses() const override;
    std::uint64_t tests() const override { return effort().tested; }
    std::shared_ptr<const FrameHistory> next_history() const override;
    const BoxTree<D>* boxes() const override { return tree_; }

    std::string_view rule_words(std::uint8_t rule) const override { return visible_rule_words[rule]; }
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item&) const override;
    Verdict why_drawn(const Item&) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;
    bool tests_planes() const override { return true; }
    std::vector<OccluderFact> occluders() const override;
    std::vector<TestedPlane<D>> tested_planes(const Item&, std::uint32_t primitive) const override;
    std::vector<TestedOccluder> tested_occluders(const Item&) const override;
    std::optional<Box<D>> eye_box() const override;
    std::optional<OccluderRegion<D>> occluder_region(std::uint32_t primitive) const override;

    /// What the frame cost so far, besides drawing.
    const Effort& effort() const { return states_.effort(); }
    const BoxStates<D>& states() const { return states_; }
    /// The thread that tested the box, from 0, of a run that was not recorded; none: it was not tested.
    std::uint32_t worker_of(std::uint32_t node) const;

private:
    void begin_frame();
    Stop next(Recorder*);
    /// Whether its state is another than in the frame before.
    bool pop(std::uint32_t node, Recorder*);
    /// What becomes of a box; marks it.
    VisibleRule settle(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch, bool& whole);
    VisibleRule rule_of(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch, bool& whole);
    bool is_in_view(std::uint32_t node, bool& whole) const;
    void refill_stack();
    void draw(std::uint32_t node, bool whole);
    /// Appends what is seen of the box and not drawn yet; an entry may come twice.
    void collect(std::uint32_t node, bool whole, std::vector<std::uint32_t>& found, std::vector<SideSeen>& facing,
                 Effort& effort, BoxScratch<D>& scratch);
    bool is_hidden(std::uint32_t leaf, std::uint32_t place, Effort& effort, BoxScratch<D>& scratch);
    void run_side_by_side();
    std::string occluders_words(std::span<const std::uint32_t> slots) const;
    Verdict why_left_out(std::uint32_t primitive) const;

    OccluderKind kind_;
    std::shared_ptr<const Prepared<D>> prepared_;
    const BoxTree<D>* tree_ = nullptr;
    BoxStates<D> states_;
    Marks marks_;
    bool by_change_ = false, by_polygons_ = false;
    int workers_ = 1;
    std::vector<std::uint32_t> stack_;
    bool stack_is_stale_ = false;
    std::vector<std::uint32_t> found_;  ///< scratch
    std::vector<SideSeen> facing_;      ///< scratch
    BoxScratch<D> scratch_;
    std::vector<std::uint8_t> worker_of_;
};

extern template class VisibleRun<2>;
extern template class VisibleRun<3>;

}  // namespace sightline
