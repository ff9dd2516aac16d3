// What a walk through portals says of itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/methods/portals/collect.h"
#include "core/methods/portals/portal_run.h"

namespace sightline {

namespace {

template <int D>
std::optional<double> windows_of(const Run<D>& run, const Item& item) {
    if (item.kind != Kind::portal && item.kind != Kind::region) return std::nullopt;
    double count = 0;
    for (const RoomVisit<D>& visit : static_cast<const PortalRun<D>&>(run).visits())
        count += item.kind == Kind::portal ? visit.portal == item.id : visit.room == item.id;
    return count;
}

}  // namespace

/// "portals 2 and 7"
template <int D>
std::string PortalRun<D>::way_to(std::uint32_t visit) const {
    std::vector<std::uint32_t> way;
    for (std::uint32_t at = visit; visits_[at].portal != none; at = visits_[at].from) way.push_back(visits_[at].portal);
    if (way.empty()) return "from where the eye is";
    std::string words = way.size() == 1 ? "through portal" : "through portals";
    for (std::size_t i = way.size(); i-- > 0;)
        words += (i + 1 == way.size() ? " " : i == 0 ? " and " : ", ") + std::to_string(way[i]);
    return words;
}

template <int D>
std::string PortalRun<D>::popped_words(const Step& step) const {
    const auto visit = static_cast<std::uint32_t>(step.key);
    const RoomVisit<D>& at = visits_[visit];
    const Rooms<D>& rooms = this->problem_.scene->rooms;
    if (rooms.empty()) return "all that is in view: the scene marks no rooms";
    const std::string into = room_words(rooms, at.room);
    if (at.portal == none) return "the eye is in " + into;
    return "through portal " + std::to_string(at.portal) + " into " + into + ", " +
           window_words(this->problem_.view, at.window);
}

template <int D>
Verdict PortalRun<D>::why_not(const Item& item) const {
    const Rooms<D>& rooms = this->problem_.scene->rooms;
    if (item.kind == Kind::cell) return {"no-cells", "the method walks from room to room, not over cells"};
    if (item.kind == Kind::region || item.kind == Kind::portal) {
        if (mark(item).state != CellState::clean) return {};
        return {"not-reached", "no window leads there"};
    }
    if (item.kind != Kind::primitive || this->drawn_.has(item.id)) return {};
    if (!turns_a_seen_side(this->problem_, item.id)) return {"turned-away", "its front is turned away from the eye"};
    if (!in_view(this->problem_.view, this->problem_.primitives()[item.id]))
        return {"outside-view", "it lies outside the view"};
    for (std::uint32_t i = 0; i < visits_.size(); ++i) {
        if (!is_looked_at(visits_[i], item.id)) continue;
        const std::string room = room_words(rooms, visits_[i].room);
        if (i >= next_ || is_seen_in(this->problem_, view_of(visits_[i]), item.id))
            return {"waits", "it lies in " + room + ", which waits", item_of(visits_[i])};
        return {"beside-window", "it lies in " + room + ", beside what is seen of it " + way_to(i),
                item_of(visits_[i])};
    }
    std::string held;
    for (std::uint32_t room = 0; room < graph_->outside() && held.empty(); ++room)
        if (is_looked_at({room, none, none, {}}, item.id)) held = room_words(rooms, room);
    return {"not-reached", "it lies in " + (held.empty() ? room_words(rooms, graph_->outside()) : held) +
                               ", to which no window leads"};
}

template <int D>
Verdict PortalRun<D>::why_drawn(const Item& item) const {
    if (item.kind != Kind::primitive || !this->drawn_.has(item.id)) return {};
    for (std::uint32_t i = 0; i < next_; ++i)
        if (is_looked_at(visits_[i], item.id) && is_seen_in(this->problem_, view_of(visits_[i]), item.id))
            return {"in-window",
                    "it is drawn as a part of " + room_words(this->problem_.scene->rooms, visits_[i].room) +
                        " in the window " + way_to(i) + "; what hides it in there is not asked",
                    item_of(visits_[i])};
    return {};
}

template <int D>
std::vector<CodeLine> PortalRun<D>::code(const CodePlace& at) const {
    const bool in_step = at.in_step(),
               starts = at.step && this->visits_[static_cast<std::size_t>(at.step->key)].portal == none;
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values = {}, std::string source = {}) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), std::move(source)});
    };
    const std::uint32_t waiting = this->counters_.front_size;
    const std::string popped = in_step ? popped_words(*at.step) : "";
    const char* const source = "Luebke and Georges 1995";
    add("the rooms that hold the eye wait, with the whole view as their window", 0,
        !at.step && this->steps_ == 0 && this->counters_.spent < this->problem_.budget, counted(waiting, "room"));
    add("while a room waits:", 0, !in_step && this->steps_ > 0 && !this->finished(),
        counted(waiting, "window") + (waiting == 1 ? " waits" : " wait"));
    add("take the first one; draw what it holds in its window", 1, in_step,
        popped + ": " + counted(at.rendered, "primitive") + (starts ? "" : " more"), source);
    add("for each portal of it whose near side the eye sees:", 1, false);
    add(D == 2 ? "cut the interval of directions to the portal" : "cut the rectangle to that around the portal's image",
        2, false, {}, source);
    add("something is left, and no window as wide is known there: the room beyond waits", 2, false, {}, source);
    lines.push_back(budget_line(*this, 1, "", false, in_step));
    lines.back().source.clear();
    add("nothing waits: done", 0,
        !in_step && this->steps_ > 0 && this->counters_.spent < this->problem_.budget && this->finished());
    return lines;
}

template <int D>
std::span<const Field<D>> PortalRun<D>::fields() const {
    static const std::array<Field<D>, 1> all{
        {{"windows", "windows", "through how many windows a room or a portal is seen", windows_of<D>}}};
    return all;
}

#define SIGHTLINE_INSTANTIATE(D)                                               \
    template std::string PortalRun<D>::way_to(std::uint32_t) const;            \
    template std::string PortalRun<D>::popped_words(const Step&) const;        \
    template Verdict PortalRun<D>::why_not(const Item&) const;                 \
    template Verdict PortalRun<D>::why_drawn(const Item&) const;               \
    template std::vector<CodeLine> PortalRun<D>::code(const CodePlace&) const; \
    template std::span<const Field<D>> PortalRun<D>::fields() const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
