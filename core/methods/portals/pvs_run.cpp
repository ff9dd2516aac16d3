// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/pvs_run.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/methods/portals/collect.h"
#include "core/run/make_steps.h"

namespace sightline {

template <int D>
PvsRun<D>::PvsRun(const Problem<D>& problem) : Run<D>(problem) {
    begin_sets();
}

template <int D>
bool PvsRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_sets();
    return true;
}

template <int D>
void PvsRun<D>::begin_sets() {
    const Scene<D>& scene = *this->problem_.scene;
    graph_ = room_graph(this->problem_);
    sets_ = room_sets(this->problem_);
    parts_.clear();
    next_ = 0;
    const RoomsAt at = rooms_at(scene.rooms, this->problem_.view.eye);
    if (at.outside) {
        parts_.emplace_back();
    } else {
        for (const std::uint32_t room : at.rooms) {
            const SeenFromRoom& set = sets_->of(scene, *graph_, room);
            for (std::uint32_t i = 0; i < set.rooms.size(); ++i) parts_.push_back({&set, room, i});
        }
    }
    this->counters_.front_size = static_cast<std::uint32_t>(parts_.size());
}

template <int D>
bool PvsRun<D>::finished() const {
    return this->counters_.spent >= this->problem_.budget ||
           (this->counters_.partial_cell == none && next_ == parts_.size());
}

template <int D>
Stop PvsRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    return make_steps(this->steps_, steps, this->counters_, recorder, [&] { return next(recorder); });
}

template <int D>
Item PvsRun<D>::item_of(const Part& part) const {
    return {part.set ? part.set->rooms[part.index].room : graph_->outside(), Kind::region};
}

template <int D>
Stop PvsRun<D>::next(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget) return Stop::budget;
    if (counters.partial_cell == none) {
        if (next_ == parts_.size()) return Stop::front_empty;
        const std::uint32_t at = next_++;
        ++this->steps_;
        --counters.front_size;
        if (recorder) {
            const bool waits = next_ < parts_.size();
            recorder->popped(item_of(parts_[at]), {double(at), at, CellState::projected},
                             waits ? item_of(parts_[next_]) : Item{}, waits ? next_ : 0);
            recorder->changed(item_of(parts_[at]), {double(at), at, CellState::enqueued}, 0);
        }
    }
    counters.partial_cell = none;
    if (!draw(parts_[next_ - 1])) counters.partial_cell = item_of(parts_[next_ - 1]).id;
    return Stop::none;
}

template <int D>
bool PvsRun<D>::draw(const Part& part) {
    const Problem<D>& problem = this->problem_;
    found_.clear();
    if (part.set)
        collect_list(problem, problem.view, this->drawn_, part.set->of(part.set->rooms[part.index]), found_);
    else
        collect_boxes(problem, problem.view, this->drawn_, found_);
    return std::all_of(found_.begin(), found_.end(),
                       [&](std::uint32_t primitive) { return this->meet(primitive, false); });
}

template <int D>
std::uint64_t PvsRun<D>::hash() const {
    Hash hash;
    for (const Part& part : parts_) hash.add(item_of(part).id);
    hash.add(next_);
    add_run(hash, *this);
    return hash.value();
}

template <int D>
Mark PvsRun<D>::mark(const Item& item) const {
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (item_of(parts_[i]) == item) return {double(i), i, i < next_ ? CellState::projected : CellState::enqueued};
    return {};
}

template <int D>
std::vector<std::pair<Item, Mark>> PvsRun<D>::front() const {
    std::vector<std::pair<Item, Mark>> waiting;
    for (std::uint32_t i = next_; i < parts_.size(); ++i)
        waiting.push_back({item_of(parts_[i]), {double(i), i, CellState::enqueued}});
    return waiting;
}

template <int D>
std::optional<std::vector<RoomSeen<D>>> PvsRun<D>::rooms_seen() const {
    if (this->problem_.scene->rooms.empty()) return std::nullopt;
    std::vector<RoomSeen<D>> seen;
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (parts_[i].set)
            seen.push_back({item_of(parts_[i]).id, i < next_ ? CellState::projected : CellState::enqueued, true, {}});
    return seen;
}

template <int D>
std::string PvsRun<D>::popped_words(const Step& step) const {
    const Part& part = parts_[static_cast<std::size_t>(step.key)];
    const Rooms<D>& rooms = this->problem_.scene->rooms;
    if (rooms.empty()) return "all that is in view: the scene marks no rooms";
    if (!part.set) return "all that is in view: the eye is outside the rooms";
    const SeenRoom& seen = part.set->rooms[part.index];
    const std::string size = counted(seen.end - seen.begin, "primitive");
    if (seen.portal == none) return "the eye is in " + room_words(rooms, seen.room) + ": " + size;
    return room_words(rooms, seen.room) + ": " + size + " can be seen from " + room_words(rooms, part.from) +
           ", the last portal being " + std::to_string(seen.portal);
}

template <int D>
Verdict PvsRun<D>::why_not(const Item& item) const {
    if (item.kind == Kind::cell) return {"no-cells", "the method draws room by room, not cells"};
    const Rooms<D>& rooms = this->problem_.scene->rooms;
    const std::string from = parts_.empty() || parts_[0].from == none ? "" : room_words(rooms, parts_[0].from);
    if (item.kind == Kind::region || item.kind == Kind::portal) {
        if (item.kind == Kind::portal || mark(item).state != CellState::clean || from.empty()) return {};
        return {"not-seen", "no line through portals leads from " + from + " to what it holds"};
    }
    if (item.kind != Kind::primitive || this->drawn_.has(item.id)) return {};
    if (!turns_a_seen_side(this->problem_, item.id)) return {"turned-away", "its front is turned away from the eye"};
    if (!in_view(this->problem_.view, this->problem_.primitives()[item.id]))
        return {"outside-view", "it lies outside the view"};
    if (next_ < parts_.size() || this->counters_.partial_cell != none)
        return {"waits", "the rooms that may hold it wait"};
    return {"not-seen", "no line through portals leads from " + from + " to it"};
}

template <int D>
std::vector<CodeLine> PvsRun<D>::code(const CodePlace& at) const {
    const bool in_step = at.in_step(), done = this->finished();
    const bool spent = this->counters_.spent >= this->problem_.budget;
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values = {}, std::string source = {}) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), std::move(source)});
    };
    std::string sets;
    std::uint32_t ways = 0;
    std::size_t bytes = 0;
    for (const Part& part : parts_)
        if (part.set && part.index == 0) ways += part.set->ways, bytes += part.set->memory_bytes();
    if (ways > 0) sets = counted(ways, "way") + " through portals, " + counted(bytes, "byte");
    add("beforehand: for each room all that a line through its portals, one after the other, can meet", 0,
        !in_step && this->steps_ == 0 && !spent, sets, "Teller and Séquin 1991");
    add("for each room that the set of the eye's room has something of:", 0, !in_step && this->steps_ > 0 && !done,
        counted(this->counters_.front_size, "room"));
    add("draw what of that is in view", 1, in_step,
        in_step ? popped_words(*at.step) + "; " + counted(at.rendered, "primitive") + " in view" : "");
    lines.push_back(budget_line(*this, 1, "", false, in_step));
    lines.back().source.clear();
    add("no room is left: done", 0, !in_step && this->steps_ > 0 && !spent && done);
    return lines;
}

template class PvsRun<2>;
template class PvsRun<3>;

}  // namespace sightline
