// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/visible_run.h"

#include <algorithm>
#include <mutex>
#include <thread>

#include "core/base/workers.h"
#include "core/run/make_steps.h"

namespace sightline {

namespace {

CellState state_after(VisibleRule rule) {
    return rule == VisibleRule::outside     ? CellState::unseen
           : rule == VisibleRule::invisible ? CellState::hidden
                                            : CellState::projected;
}
bool draws(VisibleRule rule) { return rule == VisibleRule::leaf || rule == VisibleRule::gathered; }
bool opens(VisibleRule rule) { return rule == VisibleRule::opened || rule == VisibleRule::looked_at; }

/// Subtrees for each worker, so that none waits long for the last one.
constexpr std::size_t subtrees_each = 16;

}  // namespace

template <int D>
VisibleRun<D>::VisibleRun(const Problem<D>& problem, OccluderKind kind) : Run<D>(problem), kind_(kind) {
    begin_frame();
}

template <int D>
bool VisibleRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_frame();
    return true;
}

template <int D>
void VisibleRun<D>::begin_frame() {
    const Parameters& parameters = this->problem_.parameters;
    by_change_ = parameters.template choice<StepIs>(step_is_row()) == StepIs::change;
    by_polygons_ = parameters.template choice<Leaves>(leaves_row()) == Leaves::polygons;
    workers_ = static_cast<int>(parameters.number(workers_row()));
    prepared_ = prepared(this->problem_);
    tree_ = &prepared_->tree.boxes;
    const ParameterRow& count = kind_ == OccluderKind::polygon ? occluder_count_row() : shadow_count_row();
    states_.begin(prepared_, this->problem_, kind_, static_cast<std::size_t>(parameters.number(count)));
    marks_.begin(tree_->nodes.size());
    stack_.clear();
    stack_is_stale_ = false;
    worker_of_.assign(workers_ == 1 ? 0 : tree_->nodes.size(), 0xff);
    if (tree_->nodes.empty()) return;
    marks_.set(0, {0, 0, CellState::enqueued});
    stack_.push_back(0);
    this->counters_.front_size = 1;
}

template <int D>
bool VisibleRun<D>::finished() const {
    return this->counters_.spent >= this->problem_.budget ||
           (this->counters_.partial_cell == none && this->counters_.front_size == 0);
}

template <int D>
Stop VisibleRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    if (!recorder && steps == none && workers_ != 1 && !by_change_ && this->steps_ == 0 &&
        this->problem_.budget == none)
        run_side_by_side();
    return make_steps(this->steps_, steps, this->counters_, recorder, [&] { return next(recorder); });
}

template <int D>
Stop VisibleRun<D>::next(Recorder* recorder) {
    Counters& counters = this->counters_;
    if (counters.spent >= this->problem_.budget) return Stop::budget;
    if (counters.partial_cell != none) {
        bool whole;
        is_in_view(counters.partial_cell, whole);
        const std::uint32_t node = counters.partial_cell;
        counters.partial_cell = none;
        draw(node, whole);
        return Stop::none;
    }
    if (stack_is_stale_) refill_stack();
    if (stack_.empty()) return Stop::front_empty;
    ++this->steps_;
    bool first = true, changed = false;
    do {
        const std::uint32_t node = stack_.back();
        stack_.pop_back();
        --counters.front_size;
        if (recorder) {
            const Item item{node, Kind::node};
            const Mark mark = marks_[node];
            const Item next = stack_.empty() ? Item{} : Item{stack_.back(), Kind::node};
            if (first)
                recorder->popped(item, mark, next, next ? marks_[next.id].key : 0);
            else
                recorder->ends_with(item, mark);
        }
        first = false;
        changed = pop(node, recorder);
    } while (by_change_ && !changed && !stack_.empty() && counters.partial_cell == none &&
             counters.spent < this->problem_.budget);
    return Stop::none;
}

template <int D>
bool VisibleRun<D>::is_in_view(std::uint32_t node, bool& whole) const {
    const auto corners = tree_->nodes[node].box.corners();
    const View<D>& view = this->problem_.view;
    whole = view.all_round;
    if (whole) return true;
    if (!in_view(view, std::span<const Vec<D>>(corners))) return false;
    whole = all_in_view(view, std::span<const Vec<D>>(corners));
    return true;
}

template <int D>
VisibleRule VisibleRun<D>::rule_of(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch, bool& whole) {
    if (!is_in_view(node, whole)) return VisibleRule::outside;
    const bool is_leaf = tree_->nodes[node].first_child == none;
    switch (states_.state(node, effort, scratch)) {
        case BoxState::invisible:
            return VisibleRule::invisible;
        case BoxState::partial:
            return is_leaf ? VisibleRule::leaf : VisibleRule::opened;
        default:
            return whole || is_leaf ? VisibleRule::gathered : VisibleRule::looked_at;
    }
}

/// The rule is kept as the mark's stamp: keys never tie, so that stamps have nothing else to say.
template <int D>
VisibleRule VisibleRun<D>::settle(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch, bool& whole) {
    const VisibleRule rule = rule_of(node, effort, scratch, whole);
    marks_.set(node,
               {static_cast<double>(tree_->nodes[node].begin), static_cast<std::uint32_t>(rule), state_after(rule)});
    return rule;
}

template <int D>
bool VisibleRun<D>::pop(std::uint32_t node, Recorder* recorder) {
    const Mark before = marks_[node];
    bool whole;
    const VisibleRule rule = settle(node, states_.effort(), scratch_, whole);
    if (recorder) recorder->changed({node, Kind::node}, before, static_cast<std::uint8_t>(rule));
    if (opens(rule)) {
        const typename BoxTree<D>::Node& at = tree_->nodes[node];
        for (std::uint32_t i = at.child_count; i-- > 0;) stack_.push_back(at.first_child + i);
        for (std::uint32_t i = 0; i < at.child_count; ++i) {
            const std::uint32_t child = at.first_child + i;
            if (recorder)
                recorder->changed({child, Kind::node}, marks_[child], static_cast<std::uint8_t>(VisibleRule::waits));
            marks_.set(child, {static_cast<double>(tree_->nodes[child].begin), 0, CellState::enqueued});
        }
        this->counters_.front_size += at.child_count;
    }
    if (draws(rule)) draw(node, whole);
    const auto& history = this->problem_.history;
    return history && node < history->boxes.size() && history->boxes[node] != static_cast<std::uint8_t>(rule);
}

template <int D>
void VisibleRun<D>::collect(std::uint32_t node, bool whole, std::vector<std::uint32_t>& found,
                            std::vector<SideSeen>& facing, Effort& effort, BoxScratch<D>& scratch) {
    const auto primitives = tree_->primitives_of(node);
    const std::uint32_t first = tree_->nodes[node].begin;
    const bool tests_polygons = by_polygons_ && tree_->nodes[node].first_child == none &&
                                states_.state(node, effort, scratch) == BoxState::partial;
    scratch.polygons.clear();
    tree_->tell_facing(node, this->problem_.view.eye, facing);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const std::uint32_t primitive = primitives[i];
        if (facing[i] == SideSeen::away || this->drawn_.has(primitive)) continue;
        if (!(whole ? facing[i] == SideSeen::seen || turns_a_seen_side(this->problem_, primitive)
                    : shows(this->problem_, primitive)))
            continue;
        if (tests_polygons && is_hidden(node, first + static_cast<std::uint32_t>(i), effort, scratch)) continue;
        found.push_back(primitive);
    }
}

/// Whether the polygon of a place in a PARTIAL leaf is INVISIBLE; asked once for all its primitives in the leaf.
template <int D>
bool VisibleRun<D>::is_hidden(std::uint32_t leaf, std::uint32_t place, Effort& effort, BoxScratch<D>& scratch) {
    const std::uint32_t polygon = prepared_->polygons.polygon_of[tree_->primitives[place]];
    for (const auto& [known, hidden] : scratch.polygons)
        if (known == polygon) return hidden;
    const bool hidden = states_.hides_polygon(leaf, place, effort, scratch);
    scratch.polygons.emplace_back(polygon, hidden);
    return hidden;
}

/// Until the budget ends: then the box is the partial one.
template <int D>
void VisibleRun<D>::draw(std::uint32_t node, bool whole) {
    found_.clear();
    collect(node, whole, found_, facing_, states_.effort(), scratch_);
    for (const std::uint32_t primitive : found_)
        if (!this->meet(primitive, false)) {
            this->counters_.partial_cell = node;
            return;
        }
}

/// The upper part of the tree first, then the subtrees below it, which share nothing, each by whoever is free. What is
/// drawn is put together in depth-first order, so that nothing depends on who did what.
template <int D>
void VisibleRun<D>::run_side_by_side() {
    struct Part {
        explicit Part(std::uint32_t root) : node(root) {}
        std::uint32_t node;
        bool done = false;
        std::uint32_t boxes = 0;
        Effort effort;
        std::vector<std::uint32_t> found;
    };
    const std::size_t wanted =
        subtrees_each *
        static_cast<std::size_t>(workers_ > 0 ? workers_ : std::max(1u, std::thread::hardware_concurrency()));
    // One box; appends what comes out of it.
    const auto visit = [&](std::uint32_t node, Part& part, BoxScratch<D>& scratch, std::vector<SideSeen>& facing,
                           std::uint8_t worker) {
        bool whole;
        const VisibleRule rule = settle(node, part.effort, scratch, whole);
        ++part.boxes;
        worker_of_[node] = worker;
        if (draws(rule)) collect(node, whole, part.found, facing, part.effort, scratch);
        return opens(rule);
    };
    std::vector<Part> parts, next;
    parts.emplace_back(0);
    stack_.clear();
    std::size_t open = 1;
    while (open > 0 && parts.size() < wanted) {
        next.clear();
        open = 0;
        for (Part& part : parts) {
            if (part.done) {
                next.push_back(std::move(part));
                continue;
            }
            const bool is_opened = visit(part.node, part, scratch_, facing_, 0);
            part.done = true;
            const typename BoxTree<D>::Node& at = tree_->nodes[part.node];
            next.push_back(std::move(part));
            if (!is_opened) continue;
            for (std::uint32_t i = 0; i < at.child_count; ++i) next.emplace_back(at.first_child + i);
            open += at.child_count;
        }
        std::swap(parts, next);
    }
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].done) left.push_back(i);
    std::mutex mutex;
    std::vector<std::thread::id> threads{std::this_thread::get_id()};
    run_parts(static_cast<int>(left.size()), workers_, [&](int i) {
        Part& part = parts[left[static_cast<std::size_t>(i)]];
        std::uint8_t worker;
        {
            const std::lock_guard lock(mutex);
            const auto me = std::find(threads.begin(), threads.end(), std::this_thread::get_id());
            worker = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(me - threads.begin(), 0xfe));
            if (me == threads.end()) threads.push_back(std::this_thread::get_id());
        }
        BoxScratch<D> scratch;
        std::vector<SideSeen> facing;
        std::vector<std::uint32_t> stack{part.node};
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            if (!visit(node, part, scratch, facing, worker)) continue;
            const typename BoxTree<D>::Node& at = tree_->nodes[node];
            for (std::uint32_t k = at.child_count; k-- > 0;) stack.push_back(at.first_child + k);
        }
    });
    for (const Part& part : parts) {
        this->steps_ += part.boxes;
        states_.effort() += part.effort;
        for (const std::uint32_t primitive : part.found) this->meet(primitive, false);
    }
    this->counters_.front_size = 0;
}

template <int D>
void VisibleRun<D>::refill_stack() {
    stack_.clear();
    for (const auto& [item, mark] : waiting_items(marks_, Kind::node)) stack_.push_back(item.id);
    std::reverse(stack_.begin(), stack_.end());
    stack_is_stale_ = false;
}

template <int D>
bool VisibleRun<D>::move(Direction direction, const Step& step, std::span<Change> changes, const Counters& before) {
    exchange(marks_, changes, direction == Direction::back);
    this->move_met(direction, step, before);
    stack_is_stale_ = true;
    return true;
}

/// Substep 0: the box is tested; what comes of it is not there yet.
template <int D>
void VisibleRun<D>::rewind_to(Step& step, std::vector<Change>& changes, const Counters& before, std::uint32_t) {
    undo_behind(marks_, changes, 1);
    this->drawn_.take_back(before.touched_count, this->counters_.touched_count);
    this->counters_ = before;
    --this->counters_.front_size;
    stack_is_stale_ = true;
    step.after = this->counters_;
}

template <int D>
std::uint64_t VisibleRun<D>::hash() const {
    Hash hash;
    for (std::uint32_t node = 0; node < marks_.size(); ++node) add_mark(hash, marks_[node]);
    add_run(hash, *this);
    return hash.value();
}

template <int D>
Misses VisibleRun<D>::misses() const {
    return this->counters_.front_size > 0 || this->counters_.partial_cell != none ? Misses::may : Misses::none;
}

template <int D>
std::shared_ptr<const FrameHistory> VisibleRun<D>::next_history() const {
    FrameHistory history;
    history.boxes.resize(marks_.size());
    for (std::uint32_t node = 0; node < marks_.size(); ++node)
        history.boxes[node] = static_cast<std::uint8_t>(marks_[node].stamp);
    return std::make_shared<const FrameHistory>(std::move(history));
}

template <int D>
std::uint32_t VisibleRun<D>::worker_of(std::uint32_t node) const {
    return worker_of_.empty() || worker_of_[node] == 0xff ? none : worker_of_[node];
}

template class VisibleRun<2>;
template class VisibleRun<3>;

}  // namespace sightline
