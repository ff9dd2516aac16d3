// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/portal_run.h"

#include <algorithm>

#include "core/methods/portals/collect.h"
#include "core/run/make_steps.h"

namespace sightline {

namespace {

/// In 3D a room that has been seen through so many windows is seen through one that covers them all and the next, and
/// after as many again through the whole view: wider windows show more, and no less. In 2D windows on one room do not
/// overlap, so that there are no more of them than directions between corners.
constexpr std::size_t windows_apart = 16;

}  // namespace

template <int D>
PortalRun<D>::PortalRun(const Problem<D>& problem) : Run<D>(problem) {
    begin_rooms();
}

template <int D>
bool PortalRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_rooms();
    return true;
}

template <int D>
void PortalRun<D>::begin_rooms() {
    const Problem<D>& problem = this->problem_;
    const Rooms<D>& rooms = problem.scene->rooms;
    graph_ = room_graph(problem);
    windows_ = Windows<D>(problem.view);
    visits_.clear();
    visits_of_.assign(graph_->outside() + 1, {});
    next_ = 0;
    const RoomsAt at = rooms_at(rooms, problem.view.eye);
    // Without rooms all is outside; a wall with an eye in it may be open to that side.
    closed_ = !rooms.empty() && (at.outside ? closed_for(rooms, problem.view.eye)
                                            : rooms.closed_from < std::numeric_limits<double>::infinity());
    PortalRule rule{};
    for (const std::uint32_t room : at.rooms) arrive({room, none, none, windows_.whole()}, rule);
    if (at.outside) arrive({graph_->outside(), none, none, windows_.whole()}, rule);
}

template <int D>
void PortalRun<D>::arrive(const RoomVisit<D>& visit, PortalRule& rule) {
    RoomVisit<D> comes = visit;
    std::vector<std::uint32_t>& known = visits_of_[visit.room];
    const auto is_known = [&] {
        return std::any_of(known.begin(), known.end(),
                           [&](std::uint32_t i) { return windows_.covers(visits_[i].window, comes.window); });
    };
    rule = PortalRule::known;
    if (is_known()) return;
    rule = PortalRule::leads_on;
    if (D == 3 && known.size() >= windows_apart) {
        rule = PortalRule::joined;
        for (const std::uint32_t i : known) comes.window = windows_.join(comes.window, visits_[i].window);
        if (known.size() >= 2 * windows_apart) comes.window = windows_.whole();
    }
    known.push_back(static_cast<std::uint32_t>(visits_.size()));
    visits_.push_back(comes);
    ++this->counters_.front_size;
}

template <int D>
bool PortalRun<D>::finished() const {
    return this->counters_.spent >= this->problem_.budget ||
           (this->counters_.partial_cell == none && next_ == visits_.size());
}

template <int D>
Stop PortalRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    return make_steps(this->steps_, steps, this->counters_, recorder, [&] { return next(recorder); });
}

template <int D>
Stop PortalRun<D>::next(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget) return Stop::budget;
    if (counters.partial_cell == none) {
        if (next_ == visits_.size()) return Stop::front_empty;
        const std::uint32_t visit = next_++;
        ++this->steps_;
        --counters.front_size;
        if (recorder) {
            const bool waits = next_ < visits_.size();
            recorder->popped(item_of(visits_[visit]), {double(visit), visit, CellState::projected},
                             waits ? item_of(visits_[next_]) : Item{}, waits ? next_ : 0);
        }
        look_on(visit, recorder);
    }
    counters.partial_cell = none;
    if (!draw(next_ - 1)) counters.partial_cell = visits_[next_ - 1].room;
    return Stop::none;
}

template <int D>
Item PortalRun<D>::item_of(const RoomVisit<D>& visit) const {
    return visit.portal == none ? Item{visit.room, Kind::region} : Item{visit.portal, Kind::portal};
}

template <int D>
void PortalRun<D>::look_on(std::uint32_t visit, Recorder* recorder) {
    const RoomVisit<D> here = visits_[visit];
    const RoomGraph<D>& graph = *graph_;
    const bool outside = here.room == graph.outside();
    if (outside && !closed_) return;  // all of the scene is looked at
    for (const std::uint32_t portal : graph.portals_of(here.room)) {
        const Portal<D>& at = this->problem_.scene->rooms.portals[portal];
        RoomVisit<D> there{graph.beyond(at, here.room), portal, visit, {}};
        // A point on the side that one comes from: of the room, or the far side's mirror.
        const std::uint32_t inner = outside ? there.room : here.room;
        Vec<D> near = graph.middles[inner];
        if (outside) near = at.corners[0] + (at.corners[0] - near);
        const Item item{portal, Kind::portal};
        const Mark before = recorder ? mark(item) : Mark{};
        PortalRule rule{};
        switch (windows_.pass(here.window, at, near, there.window)) {
            case Through::opens:
                arrive(there, rule);
                break;
            case Through::behind:
                rule = PortalRule::behind;
                break;
            case Through::beside:
                rule = PortalRule::beside;
                break;
        }
        if (recorder) recorder->changed(item, before, static_cast<std::uint8_t>(rule), visit);
    }
}

/// What the room holds, without a look at the window.
template <int D>
bool PortalRun<D>::is_looked_at(const RoomVisit<D>& visit, std::uint32_t primitive) const {
    const RoomContents& contents = graph_->contents;
    if (visit.room == graph_->outside()) return !closed_ || contents.outside[primitive];
    const auto row = contents.of(visit.room);
    return std::binary_search(row.begin(), row.end(), primitive);
}

template <int D>
void PortalRun<D>::collect(const RoomVisit<D>& visit, std::vector<std::uint32_t>& found) const {
    if (visit.room == graph_->outside() && !closed_)
        return collect_boxes(this->problem_, view_of(visit), this->drawn_, found);
    collect_row(this->problem_, view_of(visit), this->drawn_, *graph_, visit.room, found);
}

template <int D>
bool PortalRun<D>::draw(std::uint32_t visit) {
    found_.clear();
    collect(visits_[visit], found_);
    return std::all_of(found_.begin(), found_.end(),
                       [&](std::uint32_t primitive) { return this->meet(primitive, false); });
}

template <int D>
std::size_t PortalRun<D>::memory_bytes() const {
    return this->drawn_.memory_bytes() + visits_.capacity() * (sizeof(RoomVisit<D>) + sizeof(std::uint32_t)) +
           visits_of_.capacity() * sizeof(std::vector<std::uint32_t>);
}

template <int D>
std::uint64_t PortalRun<D>::hash() const {
    Hash hash;
    for (const RoomVisit<D>& visit : visits_) {
        hash.add(visit.room);
        hash.add(visit.portal);
        add_window(hash, visit.window);
    }
    hash.add(next_);
    add_run(hash, *this);
    return hash.value();
}

/// That of its first visit.
template <int D>
Mark PortalRun<D>::mark(const Item& item) const {
    if (item.kind != Kind::portal && item.kind != Kind::region) return {};
    for (std::uint32_t i = 0; i < visits_.size(); ++i)
        if (item.kind == Kind::portal ? visits_[i].portal == item.id : visits_[i].room == item.id)
            return {double(i), i, i < next_ ? CellState::projected : CellState::enqueued};
    return {};
}

template <int D>
std::vector<std::pair<Item, Mark>> PortalRun<D>::front() const {
    std::vector<std::pair<Item, Mark>> waiting;
    for (std::uint32_t i = next_; i < visits_.size(); ++i)
        waiting.push_back({item_of(visits_[i]), {double(i), i, CellState::enqueued}});
    return waiting;
}

template <int D>
std::optional<std::vector<RoomSeen<D>>> PortalRun<D>::rooms_seen() const {
    if (this->problem_.scene->rooms.empty()) return std::nullopt;
    std::vector<RoomSeen<D>> seen;
    for (std::uint32_t i = 0; i < visits_.size(); ++i) {
        if (visits_[i].room == graph_->outside()) continue;
        bool whole = false;
        if constexpr (D == 2) whole = visits_[i].window.all;
        seen.push_back(
            {visits_[i].room, i < next_ ? CellState::projected : CellState::enqueued, whole, view_of(visits_[i])});
    }
    return seen;
}

template <int D>
Misses PortalRun<D>::misses() const {
    return this->counters_.partial_cell == none && next_ == visits_.size() ? Misses::none : Misses::may;
}

template class PortalRun<2>;
template class PortalRun<3>;

}  // namespace sightline
