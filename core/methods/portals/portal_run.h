// From room to room through portals, each of which narrows the window: Luebke and Georges' clipping while it runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/portals/room_graph.h"
#include "core/methods/portals/window.h"
#include "core/run/method.h"
#include "core/space/box_tree.h"

namespace sightline {

/// Change::rule: what became of a portal of the room that a step looks into.
enum class PortalRule : std::uint8_t {
    leads_on,  ///< the room beyond waits, with a narrower window
    joined,    ///< the same, with a window that covers all those before: there are many
    behind,    ///< the eye is on its other side
    beside,    ///< it lies outside the window
    known,     ///< the room beyond is, or will be, looked into through a window that covers this one
};
inline constexpr auto portal_rule_words =
    std::to_array<std::string_view>({"leads on", "leads on, in one window with those before", "seen from behind",
                                     "beside the window", "known: a window as wide leads there"});

/// A room seen through a window. Steps are these, first come, first served.
template <int D>
struct RoomVisit {
    std::uint32_t room = 0;       ///< RoomGraph::outside() for what is none
    std::uint32_t portal = none;  ///< through which one comes; none: the eye is there
    std::uint32_t from = none;    ///< the visit before
    Window<D> window{};
};

/// A room of which the budget left something is Counters::partial_cell.
template <int D>
class PortalRun final : public Run<D> {
public:
    using Run<D>::mark;

    explicit PortalRun(const Problem<D>& problem);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<PortalRun>(*this); }
    std::size_t memory_bytes() const override;
    std::uint64_t hash() const override;
    Mark mark(const Item&) const override;
    std::vector<std::pair<Item, Mark>> front() const override;
    Misses misses() const override;
    std::optional<std::vector<RoomSeen<D>>> rooms_seen() const override;

    std::string_view rule_words(std::uint8_t rule) const override { return portal_rule_words[rule]; }
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item&) const override;
    Verdict why_drawn(const Item&) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;
    std::span<const Field<D>> fields() const override;

    /// Those that came so far, also those that wait.
    std::span<const RoomVisit<D>> visits() const { return visits_; }
    View<D> view_of(const RoomVisit<D>& visit) const { return windows_.view_of(visit.window); }

private:
    void begin_rooms();
    Stop next(Recorder*);
    void arrive(const RoomVisit<D>& visit, PortalRule& rule);
    void look_on(std::uint32_t visit, Recorder*);
    /// False: the budget ended it.
    bool draw(std::uint32_t visit);
    void collect(const RoomVisit<D>& visit, std::vector<std::uint32_t>& found) const;
    bool is_looked_at(const RoomVisit<D>& visit, std::uint32_t primitive) const;
    Item item_of(const RoomVisit<D>& visit) const;
    std::string way_to(std::uint32_t visit) const;

    std::shared_ptr<const RoomGraph<D>> graph_;
    Windows<D> windows_;
    bool closed_ = false;  ///< the outside holds its own row only, and leads into rooms
    std::vector<RoomVisit<D>> visits_;
    std::vector<std::vector<std::uint32_t>> visits_of_;  ///< per room
    std::uint32_t next_ = 0;                             ///< of visits_
    std::vector<std::uint32_t> found_;                   ///< scratch
};

extern template class PortalRun<2>;
extern template class PortalRun<3>;

}  // namespace sightline
