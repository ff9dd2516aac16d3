// Draws what can be seen from the eye's room, as it was found beforehand, room by room.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/portals/pvs.h"
#include "core/run/method.h"

namespace sightline {

/// Its items are the rooms of the set, each drawn as far as it lies in view; an eye outside all rooms draws all that is
/// in view in one step. A room of which the budget left something is Counters::partial_cell.
template <int D>
class PvsRun final : public Run<D> {
public:
    using Run<D>::mark;

    explicit PvsRun(const Problem<D>& problem);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<PvsRun>(*this); }
    std::size_t memory_bytes() const override { return this->drawn_.memory_bytes() + parts_.capacity() * sizeof(Part); }
    std::uint64_t hash() const override;
    Mark mark(const Item&) const override;
    std::vector<std::pair<Item, Mark>> front() const override;
    Misses misses() const override {
        return this->counters_.partial_cell == none && next_ == parts_.size() ? Misses::none : Misses::may;
    }
    std::optional<std::vector<RoomSeen<D>>> rooms_seen() const override;

    std::string_view rule_words(std::uint8_t) const override { return "drawn"; }
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item&) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;

private:
    /// A room of a set; set == nullptr: all that is in view.
    struct Part {
        const SeenFromRoom* set = nullptr;
        std::uint32_t from = none, index = 0;  ///< the eye's room; of set->rooms
    };
    void begin_sets();
    Stop next(Recorder*);
    bool draw(const Part& part);
    Item item_of(const Part& part) const;

    std::shared_ptr<const RoomGraph<D>> graph_;
    std::shared_ptr<const RoomSets<D>> sets_;
    std::vector<Part> parts_;
    std::uint32_t next_ = 0;
    std::vector<std::uint32_t> found_;  ///< scratch
};

extern template class PvsRun<2>;
extern template class PvsRun<3>;

}  // namespace sightline
