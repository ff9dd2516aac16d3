// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/levels/levels_run.h"

#include <algorithm>

#include "core/run/make_steps.h"

namespace sightline {

template <int D>
LevelsRun<D>::LevelsRun(const Problem<D>& problem) : Run<D>(problem) {
    begin_objects();
}

template <int D>
bool LevelsRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_objects();
    return true;
}

template <int D>
void LevelsRun<D>::begin_objects() {
    const Problem<D>& problem = this->problem_;
    const Parameters& parameters = problem.parameters;
    levels_ = levels_of(*problem.cells, *problem.scene);
    scale_ = PixelScale<D>(problem.view, problem.services.image);
    cost_ = {parameters.number(vertex_ns_row()), parameters.number(pixel_ns_row())};
    reading_ = parameters.template choice<CostReading>(cost_row());
    pixel_error_ = parameters.number(pixel_error_row());
    target_ms_ = parameters.number(frame_ms_row());
    marks_.begin(levels_->object_count());
    std::vector<std::pair<double, std::uint32_t>> far_to_near;
    constexpr std::uint32_t size = Levels<D>::group_size;
    whole_groups_.assign(levels_->group_boxes.size(), 0);
    if constexpr (D == 3) facing_.resize(problem.primitives().size());
    for (std::uint32_t group = 0; group < levels_->group_boxes.size(); ++group) {
        const auto around = levels_->group_boxes[group].corners();
        if (!in_view(problem.view, std::span<const Vec<D>>(around))) continue;
        const bool whole = all_in_view(problem.view, std::span<const Vec<D>>(around));
        whole_groups_[group] = whole;
        const std::uint32_t end = std::min(levels_->object_count(), (group + 1) * size);
        if constexpr (D == 3) {
            const std::uint32_t first = levels_->rows.first[group * size], after = levels_->rows.first[end];
            levels_->facing.tell(problem.view.eye, first, std::span(facing_).subspan(first, after - first));
        }
        for (std::uint32_t object = group * size; object < end; ++object) {
            const Box<D>& box = levels_->boxes[object];
            const auto corners = box.corners();
            if (whole || in_view(problem.view, std::span<const Vec<D>>(corners)))
                far_to_near.emplace_back(-squared_distance(box, problem.view.eye), object);
        }
    }
    std::sort(far_to_near.begin(), far_to_near.end());
    order_.clear();
    for (const auto& [key, object] : far_to_near) {
        marks_.set(object, {-std::sqrt(-key), static_cast<std::uint32_t>(order_.size()), CellState::enqueued});
        order_.push_back(object);
    }
    this->counters_.front_size = this->counters_.next_stamp = static_cast<std::uint32_t>(order_.size());
    level_of_.clear();
    frames_.clear();
    if (target_ms_ > 0) frames_.push_back(frame_with(0));
    stand_ins_at_ = none;
}

/// Those that are not in the order lie outside the view.
template <int D>
Mark LevelsRun<D>::mark(const Item& item) const {
    if (item.kind != Kind::object) return {};
    const Mark mark = marks_[item.id];
    return mark.state == CellState::clean ? Mark{0, 0, CellState::unseen} : mark;
}

template <int D>
DrawnSize LevelsRun<D>::size_of(std::uint32_t object, std::uint32_t level) const {
    const std::size_t count = level > 0 ? levels_->at(object, level).count() : levels_->primitives_of(object).size();
    return {D * count, scale_.pixels_of(levels_->boxes[object])};
}

template <int D>
FrameDrawing LevelsRun<D>::frame_with(std::uint32_t taken) const {
    FrameDrawing frame(cost_);
    for (const std::uint32_t object : order_) frame.add(size_of(object, 0));
    for (std::uint32_t place = 0; place < taken; ++place)
        if (level_of_[place] > 0) {
            frame.take_out(size_of(order_[place], 0));
            frame.add(size_of(order_[place], level_of_[place]));
        }
    return frame;
}

template <int D>
double LevelsRun<D>::frame_ms(std::uint32_t taken, CostReading reading) const {
    return frame_with(taken).ms(reading);
}

/// The coarsest level that is no more than pixel_error_ off; 0: as it is.
template <int D>
std::uint8_t LevelsRun<D>::choose(std::uint32_t object) const {
    const auto levels = levels_->of(object);
    if (levels.empty() || is_cheap_enough()) return 0;
    const double pixels = scale_.pixels_per_unit(levels_->boxes[object]);
    std::size_t level = std::min<std::size_t>(levels.size(), 255);
    while (level > 0 && !(levels[level - 1].error * pixels <= pixel_error_)) --level;
    return static_cast<std::uint8_t>(level);
}

/// Whether the object at hand has not got its place in the budget yet.
template <int D>
bool LevelsRun<D>::waits_for_place() const {
    const Counters& counters = this->counters_;
    if (counters.partial_cell == none || level_of_.back() == 0) return false;
    return levels_->at(counters.partial_cell, level_of_.back()).count() > this->problem_.budget - counters.spent;
}

template <int D>
bool LevelsRun<D>::finished() const {
    const Counters& counters = this->counters_;
    return counters.spent >= this->problem_.budget || waits_for_place() ||
           (counters.partial_cell == none && this->steps_ == order_.size());
}

template <int D>
Stop LevelsRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    return make_steps(this->steps_, steps, this->counters_, recorder, [&] { return next(recorder); });
}

template <int D>
Stop LevelsRun<D>::next(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget || waits_for_place()) return Stop::budget;
    if (counters.partial_cell != none) {
        if (draw(counters.partial_cell)) counters.partial_cell = none;
        return Stop::none;
    }
    if (this->steps_ == order_.size()) return Stop::front_empty;
    const std::uint32_t object = order_[this->steps_++];
    const Mark before = marks_[object];
    if (recorder) {
        const Item other = this->steps_ < order_.size() ? Item{order_[this->steps_], Kind::object} : Item{};
        recorder->popped({object, Kind::object}, {before.key, before.stamp, CellState::projected}, other,
                         other ? marks_[other.id].key : 0);
    }
    const bool enough = is_cheap_enough();
    const std::uint8_t level = choose(object);
    const LevelRule rule = level > 0 ? LevelRule::coarser : enough ? LevelRule::enough : LevelRule::as_it_is;
    if (recorder) recorder->changed({object, Kind::object}, before, static_cast<std::uint8_t>(rule), level);
    Mark after = before;
    after.state = CellState::projected;
    marks_.set(object, after);
    --counters.front_size;
    take(object, level);
    counters.partial_cell = draw(object) ? none : object;
    return Stop::none;
}

/// The object at the next place gets its level.
template <int D>
void LevelsRun<D>::take(std::uint32_t object, std::uint8_t level) {
    level_of_.push_back(level);
    stand_ins_at_ = none;
    if (target_ms_ == 0) return;
    FrameDrawing frame = frames_.back();
    if (level > 0) {
        frame.take_out(size_of(object, 0));
        frame.add(size_of(object, level));
    }
    frames_.push_back(frame);
}

/// False where the budget has no place for it, or for the rest of it.
template <int D>
bool LevelsRun<D>::draw(std::uint32_t object) {
    stand_ins_at_ = none;
    if (level_of_.back() == 0) return draw_as_it_is(object);
    const std::uint32_t count = levels_->at(object, level_of_.back()).count();
    if (count > this->problem_.budget - this->counters_.spent) return false;
    this->counters_.stood_in += count;
    this->counters_.spent += count;
    return true;
}

template <int D>
bool LevelsRun<D>::draw_as_it_is(std::uint32_t object) {
    const Problem<D>& problem = this->problem_;
    Counters& counters = this->counters_;
    const auto primitives = levels_->primitives_of(object);
    bool whole = whole_groups_[object / Levels<D>::group_size];
    if (!whole) {
        const auto corners = levels_->boxes[object].corners();
        whole = all_in_view(problem.view, std::span<const Vec<D>>(corners));
    }
    const std::uint32_t first = levels_->rows.first[object];
    found_.clear();
    for (std::size_t i = counters.offset; i < primitives.size(); ++i) {
        const SideSeen side = D == 2 ? SideSeen::seen : facing_[first + i];
        if (side == SideSeen::away || (side == SideSeen::unsure && !turns_a_seen_side(problem, primitives[i])))
            continue;
        if (!whole && !in_view(problem.view, problem.primitives()[primitives[i]])) continue;
        if (found_.size() == problem.budget - counters.spent) {
            counters.offset = static_cast<std::uint32_t>(i);
            meet_all(found_, this->drawn_, counters);
            return false;
        }
        found_.push_back(primitives[i]);
    }
    counters.offset = 0;
    meet_all(found_, this->drawn_, counters);
    return true;
}

template <int D>
bool LevelsRun<D>::move(Direction direction, const Step& step, std::span<Change> changes, const Counters& before) {
    if (direction == Direction::back) {
        level_of_.pop_back();
        if (target_ms_ > 0) frames_.pop_back();
    } else {
        take(step.item.id, static_cast<std::uint8_t>(changes.front().via));
    }
    exchange(marks_, changes, direction == Direction::back);
    this->move_met(direction, step, before);
    stand_ins_at_ = none;
    return true;
}

/// Substep 0: it is taken from those that wait; what is drawn is not there yet.
template <int D>
void LevelsRun<D>::rewind_to(Step& step, std::vector<Change>&, const Counters& before, std::uint32_t) {
    this->drawn_.take_back(before.touched_count, this->counters_.touched_count);
    const std::uint32_t front_size = this->counters_.front_size;
    this->counters_ = before;
    this->counters_.front_size = front_size;
    this->counters_.partial_cell = step.item.id;
    stand_ins_at_ = none;
    step.after = this->counters_;
}

template <int D>
std::span<const StandIn> LevelsRun<D>::stand_ins() const {
    if (stand_ins_at_ != this->steps_) {
        stand_ins_.clear();
        for (std::uint32_t place = 0; place < level_of_.size(); ++place)
            if (level_of_[place] > 0 && order_[place] != this->counters_.partial_cell)
                stand_ins_.push_back({order_[place], level_of_[place]});
        std::sort(stand_ins_.begin(), stand_ins_.end(),
                  [](const StandIn& a, const StandIn& b) { return a.object < b.object; });
        stand_ins_at_ = this->steps_;
    }
    return stand_ins_;
}

template <int D>
std::size_t LevelsRun<D>::memory_bytes() const {
    return marks_.memory_bytes() + whole_groups_.capacity() + this->drawn_.memory_bytes() +
           order_.capacity() * sizeof(std::uint32_t) + level_of_.capacity() + facing_.capacity() +
           frames_.capacity() * sizeof(FrameDrawing) + stand_ins_.capacity() * sizeof(StandIn);
}

template <int D>
std::uint64_t LevelsRun<D>::hash() const {
    Hash hash;
    for (std::uint32_t object = 0; object < marks_.size(); ++object) add_mark(hash, marks_[object]);
    for (const std::uint8_t level : level_of_) hash.add(level);
    add_run(hash, *this);
    hash.add(this->counters_.stood_in);
    return hash.value();
}

template <int D>
Misses LevelsRun<D>::misses() const {
    const bool complete = this->steps_ == order_.size() && this->counters_.partial_cell == none;
    // A level shows its object in another shape.
    return complete && this->counters_.stood_in == 0 ? Misses::none : Misses::may;
}

template class LevelsRun<2>;
template class LevelsRun<3>;

}  // namespace sightline
