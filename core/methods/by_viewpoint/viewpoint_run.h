// One frame by viewpoint: the look-up as a step, then the steps of the technique that it found (DAS 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/by_viewpoint/viewpoint_table.h"

namespace sightline {

/// Its first step pops the region of the eye; all others are those of the technique, which the work is left to.
template <int D>
class ViewpointRun final : public Run<D> {
public:
    using Run<D>::mark;

    ViewpointRun(const Problem<D>& problem, std::shared_ptr<const ViewpointTable<D>> table);
    ViewpointRun(const ViewpointRun& other);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override { return looked_up_ && inner().finished(); }
    void set_budget(std::uint32_t budget) override;

    bool undoes_by_marks() const override { return inner().undoes_by_marks(); }
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override;
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<ViewpointRun>(*this); }
    std::size_t memory_bytes() const override;

    const Run<D>& worker() const override { return inner().worker(); }
    std::uint32_t steps() const override { return looked_up_ + inner().steps(); }
    void remember(std::span<const Met> all) override { runs_[chosen_]->remember(all); }
    std::uint64_t hash() const override;
    Mark mark(const Item& item) const override;
    std::vector<std::pair<Item, Mark>> front() const override { return inner().front(); }
    std::span<const Item> seeds() const override { return inner().seeds(); }
    Misses misses() const override { return looked_up_ ? inner().misses() : Misses::may; }
    std::uint32_t met_before_completing() const override { return inner().met_before_completing(); }
    std::uint64_t tests() const override { return inner().tests(); }
    std::shared_ptr<const FrameHistory> next_history() const override;
    std::span<const StandIn> stand_ins() const override { return inner().stand_ins(); }
    std::shared_ptr<const Levels<D>> levels() const override { return inner().levels(); }

    std::string_view rule_words(std::uint8_t rule) const override { return inner().rule_words(rule); }
    std::vector<Considered> considered(const Step&, std::span<const Change>, int digits) const override;
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item& item) const override { return inner().why_not(item); }
    std::optional<KeyExplanation> key_terms(const Item& item, int digits) const override {
        return inner().key_terms(item, digits);
    }
    Verdict why_drawn(const Item& item) const override { return inner().why_drawn(item); }
    Verdict why_waiting(const Item& item) const override { return inner().why_waiting(item); }
    std::vector<CodeLine> code(const CodePlace&) const override;
    std::span<const Field<D>> fields() const override { return inner().fields(); }
    std::vector<ReadTile> tiles() const override { return inner().tiles(); }
    /// Where the technique walks none, those of the scene: its items count as nodes all the same.
    const BoxTree<D>* boxes() const override {
        const BoxTree<D>* const walked = inner().boxes();
        return walked ? walked : &this->problem_.boxes();
    }
    bool tests_planes() const override { return inner().tests_planes(); }
    std::vector<OccluderFact> occluders() const override { return inner().occluders(); }
    std::vector<TestedPlane<D>> tested_planes(const Item& box, std::uint32_t primitive) const override {
        return inner().tested_planes(box, primitive);
    }
    std::vector<TestedOccluder> tested_occluders(const Item& box) const override {
        return inner().tested_occluders(box);
    }
    std::optional<std::vector<RoomSeen<D>>> rooms_seen() const override { return inner().rooms_seen(); }
    std::optional<Box<D>> eye_box() const override { return table_->regions().box(table_->region_of(place_)); }
    std::optional<OccluderRegion<D>> occluder_region(std::uint32_t primitive) const override {
        return inner().occluder_region(primitive);
    }

    std::optional<ViewpointFact<D>> viewpoint() const override;

    const ViewpointTable<D>& table() const { return *table_; }
    const std::shared_ptr<const ViewpointTable<D>>& shared_table() const { return table_; }
    std::size_t place() const { return place_; }         ///< of the entry in the table
    std::uint32_t technique() const { return chosen_; }  ///< of problem().options
    /// The entry chose another one, and changing to it does not pay.
    bool keeps_the_last() const { return chosen_ != table_->find(place_)->chosen; }

private:
    void look_up();
    const Run<D>& inner() const { return *runs_[chosen_]; }
    /// Rooms are regions too, and techniques pop them.
    static constexpr std::uint32_t look_up_stamp = none;
    bool is_look_up(const Step& step) const { return step.item.kind == Kind::region && step.stamp == look_up_stamp; }

    std::shared_ptr<const ViewpointTable<D>> table_;
    std::size_t place_ = 0;
    std::uint32_t chosen_ = 0, before_ = none;
    bool looked_up_ = false;
    std::vector<OwnRun<D>> runs_;  ///< a technique's own memory; only that of chosen_ is of this frame
};

extern template class ViewpointRun<2>;
extern template class ViewpointRun<3>;

}  // namespace sightline
