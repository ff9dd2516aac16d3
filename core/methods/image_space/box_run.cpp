// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/box_run.h"

#include <algorithm>

#include "core/methods/image_space/occluders.h"
#include "core/scene/view.h"

namespace sightline {

template <int D>
BoxRun<D>::BoxRun(const Problem<D>& problem, const BoxMethod& method, Picker picker)
    : Run<D>(problem), method_(method), picker_(std::move(picker)) {
    begin_boxes();
}

template <int D>
bool BoxRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_boxes();
    return true;
}

template <int D>
void BoxRun<D>::begin_boxes() {
    const Parameters& parameters = this->problem_.parameters;
    const auto draws = parameters.template choice<Draws>(draws_row());
    all_winners_ = (draws == Draws::own ? method_.draws : draws) == Draws::winners;
    refresh_ =
        method_.test == BoxMethod::Test::pixels ? 1 : static_cast<std::uint32_t>(parameters.number(refresh_row()));
    opacity_ = method_.test == BoxMethod::Test::opacity ? parameters.number(opacity_row()) : 1;
    tree_ = &this->problem_.boxes();
    const double worth = method_.test == BoxMethod::Test::depth ? parameters.number(worth_row()) : 0;
    tests_depth_ = method_.test != BoxMethod::Test::view && (worth == 0 || are_worth_testing(worth));
    marks_.begin(tree_->nodes.size());
    front_.clear();
    front_is_stale_ = false;
    waiting_.clear();
    screen_.forget();
    occluders_.clear();
    if (tests_depth()) {
        const auto asked = parameters.template choice<Occluders>(occluders_row());
        occluders_ = occluders<D>(this->problem_, asked == Occluders::own ? method_.occluders : asked, picker_);
    }
    if (!tree_->nodes.empty()) enqueue(0, nullptr);
}

/// Whether more primitives lie in view than one for so many pixels. Looks at no more boxes than that takes.
template <int D>
bool BoxRun<D>::are_worth_testing(double worth) const {
    const ImageSize size = image_size<D>(this->problem_.services.image);
    const double enough = static_cast<double>(size.width) * std::max(size.height, 1) / worth;
    const View<D>& view = this->problem_.view;
    std::vector<std::uint32_t> nodes;
    if (!tree_->nodes.empty()) nodes.push_back(0);
    double found = 0;
    while (!nodes.empty() && found <= enough) {
        const typename BoxTree<D>::Node& at = tree_->nodes[nodes.back()];
        nodes.pop_back();
        const auto corners = at.box.corners();
        if (!in_view(view, std::span<const Vec<D>>(corners))) continue;
        if (at.first_child == none || all_in_view(view, std::span<const Vec<D>>(corners)))
            found += at.end - at.begin;
        else
            nodes.insert(nodes.end(), {at.first_child, at.first_child + 1});
    }
    return found > enough;
}

template <int D>
void BoxRun<D>::enqueue(std::uint32_t node, Recorder* recorder) {
    const typename BoxTree<D>::Node& at = tree_->nodes[node];
    const Mark mark{tests_depth() ? squared_distance(at.box, this->problem_.view.eye) : at.begin,
                    this->counters_.next_stamp, CellState::enqueued};
    if (recorder) recorder->changed({node, Kind::node}, marks_[node], static_cast<std::uint8_t>(BoxRule::enqueued));
    marks_.set(node, mark);
    front_.push({mark.key, mark.stamp, node});
    ++this->counters_.next_stamp;
    ++this->counters_.front_size;
}

template <int D>
const Front::Entry* BoxRun<D>::front_top() {
    if (front_is_stale_) {
        refill(front_, marks_);
        front_is_stale_ = false;
    }
    return front_.top([](const Front::Entry&) { return true; });
}

template <int D>
bool BoxRun<D>::finished() const {
    const Counters& counters = this->counters_;
    return counters.spent >= this->problem_.budget ||
           (this->steps_ >= occluder_steps() && counters.partial_cell == none && counters.front_size == 0);
}

template <int D>
Stop BoxRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    const std::uint64_t end = std::uint64_t{this->steps_} + steps;
    Stop stop = Stop::none;
    while (stop == Stop::none && this->steps_ < end) {
        stop = next(recorder);
        if (!recorder) continue;
        draw_waiting();
        if (stop == Stop::none) recorder->finished(this->counters_);
    }
    draw_waiting();
    return stop == Stop::none ? Stop::steps : stop;
}

template <int D>
Stop BoxRun<D>::next(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget) return Stop::budget;
    if (counters.partial_cell == occluders_left() || this->steps_ < occluder_steps()) {
        if (counters.partial_cell == none) {
            ++this->steps_;
            if (recorder) recorder->popped({}, {});
        }
        meet_occluders();
        return Stop::none;
    }
    if (counters.partial_cell != none) {
        sync();
        if (draw_slowly(counters.partial_cell)) counters.partial_cell = none;
        return Stop::none;
    }
    const Front::Entry* top = front_top();
    if (!top) return Stop::front_empty;
    const Front::Entry entry = *top;
    refresh_if_due();
    front_.pop();
    --counters.front_size;
    ++this->steps_;
    if (recorder) {
        const Front::Entry* second = front_top();
        recorder->popped({entry.id, Kind::node}, {entry.key, entry.stamp, CellState::projected},
                         second ? Item{second->id, Kind::node} : Item{}, second ? second->key : 0);
    }
    pop(entry, recorder);
    return Stop::none;
}

/// Those of one step; up to the end of the budget.
template <int D>
void BoxRun<D>::meet_occluders() {
    Counters& counters = this->counters_;
    const std::size_t end = std::min(occluders_.size(), std::size_t{this->steps_} * batch);
    counters.partial_cell = none;
    for (; counters.offset < end; ++counters.offset)
        if (!this->meet(occluders_[counters.offset], false)) {
            counters.partial_cell = occluders_left();
            return;
        }
    if (end == occluders_.size()) counters.offset = 0;
}

template <int D>
void BoxRun<D>::sync() {
    if (tests_depth()) screen_.show(this->problem_, this->met(), this->counters_.refreshed, opacity_);
}

template <int D>
void BoxRun<D>::refresh_if_due() {
    if (!tests_depth()) return;
    const std::uint32_t popped = this->steps_ - occluder_steps();
    if (popped != 0 && (is_fixed() || popped % refresh_ != 0)) return;
    draw_waiting();
    sync();
    this->counters_.refreshed = this->counters_.touched_count;
    screen_.refresh(opacity_);
}

template <int D>
BoxSight BoxRun<D>::sight_of(std::uint32_t node, bool& whole) {
    const Box<D>& box = tree_->nodes[node].box;
    whole = false;
    if (tests_depth()) {
        sync();
        return method_.test == BoxMethod::Test::pixels ? screen_.look_closely(this->problem_.view, box)
                                                       : screen_.look(box);
    }
    const auto corners = box.corners();
    const View<D>& view = this->problem_.view;
    if (!in_view(view, std::span<const Vec<D>>(corners))) return BoxSight::outside;
    whole = all_in_view(view, std::span<const Vec<D>>(corners));
    return BoxSight::seen;
}

template <int D>
void BoxRun<D>::pop(const Front::Entry& entry, Recorder* recorder) {
    const std::uint32_t node = entry.id;
    const typename BoxTree<D>::Node& at = tree_->nodes[node];
    bool whole;
    const BoxSight sight = sight_of(node, whole);
    const bool draws = whole || at.first_child == none;
    const BoxRule rule = sight == BoxSight::outside  ? BoxRule::outside
                         : sight == BoxSight::hidden ? BoxRule::hidden
                         : draws                     ? BoxRule::drawn
                                                     : BoxRule::opened;
    const Mark before{entry.key, entry.stamp, CellState::enqueued};
    Mark after = before;
    after.state = sight == BoxSight::outside  ? CellState::unseen
                  : sight == BoxSight::hidden ? CellState::hidden
                                              : CellState::projected;
    marks_.set(node, after);
    if (recorder) recorder->changed({node, Kind::node}, before, static_cast<std::uint8_t>(rule));
    if (rule == BoxRule::opened) {
        enqueue(at.first_child, recorder);
        enqueue(at.first_child + 1, recorder);
    }
    if (rule != BoxRule::drawn) return;
    Counters& counters = this->counters_;
    const std::uint32_t left = this->problem_.budget == none ? none : this->problem_.budget - counters.spent;
    if (waiting_.size() + (at.end - at.begin) < left) {
        collect(node, whole, waiting_);
        return;
    }
    draw_waiting();
    sync();
    counters.partial_cell = node;
    if (draw_slowly(node)) counters.partial_cell = none;
}

/// Whether it is drawn, or may be.
template <int D>
bool BoxRun<D>::is_drawn(std::uint32_t primitive, SideSeen facing, bool whole) const {
    if (facing == SideSeen::away || this->drawn_.has(primitive)) return false;
    if (whole) return facing == SideSeen::seen || turns_a_seen_side(this->problem_, primitive);
    return wins_pixels() || shows(this->problem_, primitive);
}

template <int D>
void BoxRun<D>::collect(std::uint32_t node, bool whole, std::vector<std::uint32_t>& found) {
    const auto primitives = tree_->primitives_of(node);
    tree_->tell_facing(node, this->problem_.view.eye, facing_);
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (is_drawn(primitives[i], facing_[i], whole)) found.push_back(primitives[i]);
}

template <int D>
void BoxRun<D>::draw_waiting() {
    if (waiting_.empty()) return;
    if (wins_pixels()) {
        const auto won = screen_.draw(waiting_);
        for (std::size_t i = 0; i < won.size(); ++i)
            if (won[i]) this->meet(waiting_[i], false);
        screen_.met(this->counters_.touched_count);
    } else {
        meet_all(waiting_, this->drawn_, this->counters_);
    }
    waiting_.clear();
}

template <int D>
bool BoxRun<D>::draw_slowly(std::uint32_t node) {
    Counters& counters = this->counters_;
    const auto primitives = tree_->primitives_of(node);
    bool whole;
    if (tests_depth())
        whole = false;
    else
        sight_of(node, whole);
    for (; counters.offset < primitives.size(); ++counters.offset) {
        const std::uint32_t primitive = primitives[counters.offset];
        if (!is_drawn(primitive, SideSeen::unsure, whole)) continue;
        if (counters.spent >= this->problem_.budget) return false;
        if (wins_pixels() && !screen_.draw({&primitive, 1})[0]) continue;
        this->meet(primitive, false);
        if (wins_pixels()) screen_.met(counters.touched_count);
    }
    counters.offset = 0;
    return true;
}

template <int D>
bool BoxRun<D>::move(Direction direction, const Step& step, std::span<Change> changes, const Counters& before) {
    exchange(marks_, changes, direction == Direction::back);
    this->move_met(direction, step, before);
    front_is_stale_ = true;
    if (direction == Direction::back) screen_.forget();
    return true;
}

/// Substep 0: the box is tested; what comes of it is not there yet.
template <int D>
void BoxRun<D>::rewind_to(Step& step, std::vector<Change>& changes, const Counters& before, std::uint32_t) {
    undo_behind(marks_, changes, 1);
    const bool pops = step.item.kind == Kind::node;
    this->drawn_.take_back(before.touched_count, this->counters_.touched_count);
    const std::uint32_t refreshed = this->counters_.refreshed;
    this->counters_ = before;
    if (pops) {
        --this->counters_.front_size;
        this->counters_.refreshed = refreshed;
    }
    front_is_stale_ = true;
    step.after = this->counters_;
}

template <int D>
std::size_t BoxRun<D>::memory_bytes() const {
    return marks_.memory_bytes() + this->drawn_.memory_bytes() + occluders_.capacity() * sizeof(std::uint32_t);
}

template <int D>
std::uint64_t BoxRun<D>::hash() const {
    Hash hash;
    for (std::uint32_t node = 0; node < marks_.size(); ++node) add_mark(hash, marks_[node]);
    add_run(hash, *this);
    hash.add(this->counters_.refreshed);
    return hash.value();
}

template <int D>
std::vector<std::pair<Item, Mark>> BoxRun<D>::front() const {
    return waiting_items(marks_, Kind::node);
}

template <int D>
Misses BoxRun<D>::misses() const {
    const Counters& counters = this->counters_;
    if (counters.front_size > 0 || counters.partial_cell != none || this->steps_ < occluder_steps() || opacity_ < 1)
        return Misses::may;
    return tests_depth() ? Misses::none_at_this_resolution : Misses::none;
}

template <int D>
std::shared_ptr<const FrameHistory> BoxRun<D>::next_history() const {
    if (!tests_depth()) return nullptr;
    Screen<D> anew;
    if (!screen_.shows(this->met())) anew.show(this->problem_, this->met(), 0);
    const Screen<D>& screen = screen_.shows(this->met()) ? screen_ : anew;
    FrameHistory history;
    history.visible.assign(this->problem_.primitives().size(), 0);
    for (const std::uint32_t id : screen.image().image().ids)
        if (id != none) history.visible[id] = 1;
    return std::make_shared<const FrameHistory>(std::move(history));
}

template class BoxRun<2>;
template class BoxRun<3>;

}  // namespace sightline
