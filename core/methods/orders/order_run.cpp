// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/orders/order_run.h"

namespace sightline {

template <int D>
OrderRun<D>::OrderRun(const Problem<D>& problem, const PrimitiveOrder<D>& order) : Run<D>(problem), order_(order) {
    begin_order();
}

template <int D>
bool OrderRun<D>::restart(const Problem<D>& problem) {
    this->begin(problem);
    begin_order();
    return true;
}

template <int D>
void OrderRun<D>::begin_order() {
    if (order_.primitives) {
        primitives_ = order_.primitives(this->problem_);
        count_ = static_cast<std::uint32_t>(primitives_.size());
    } else {
        primitives_.clear();
        shown_.clear();
        nearest_.begin(this->problem_);
        count_ = static_cast<std::uint32_t>(this->problem_.primitives().size());
    }
}

/// False when the budget has no place for it.
template <int D>
bool OrderRun<D>::meet_next() {
    const std::uint32_t offset = this->counters_.offset;
    if (order_.primitives) return this->meet(primitives_[offset], order_.culls);
    while (offset >= primitives_.size()) nearest_.extend(primitives_, shown_);
    const std::uint32_t primitive = primitives_[offset];
    const bool culled =
        shown_[offset] == Showing::no || (shown_[offset] == Showing::unsure && !shows(this->problem_, primitive));
    return add_met(this->problem_.budget, this->culled_costs_, {primitive, culled}, this->drawn_, this->counters_);
}

/// One batch of the order, or the rest of the batch that the budget cut.
template <int D>
Stop OrderRun<D>::batch(Recorder* recorder) {
    std::uint32_t& offset = this->counters_.offset;
    if (offset >= count_) return Stop::front_empty;
    if (this->counters_.spent >= this->problem_.budget) return Stop::budget;
    if (offset % order_.batch == 0) {
        ++this->steps_;
        if (recorder) recorder->popped(order_.batch == 1 ? primitive_item(primitives_[offset]) : Item{}, {});
    }
    do {
        if (!meet_next()) break;
        ++offset;
    } while (offset < count_ && offset % order_.batch != 0);
    if (recorder) recorder->finished(this->counters_);
    return Stop::none;
}

template <int D>
Stop OrderRun<D>::run(std::uint32_t steps, Recorder* recorder) {
    const std::uint64_t end = std::uint64_t{this->steps_} + steps;
    while (this->steps_ < end)
        if (const Stop stop = batch(recorder); stop != Stop::none) return stop;
    return Stop::steps;
}

template <int D>
bool OrderRun<D>::finished() const {
    return this->counters_.spent >= this->problem_.budget || this->counters_.offset >= count_;
}

template <int D>
bool OrderRun<D>::move(Direction direction, const Step& step, std::span<Change>, const Counters& before) {
    this->move_met(direction, step, before);
    return true;
}

template <int D>
void OrderRun<D>::rewind_to(Step& step, std::vector<Change>&, const Counters& before, std::uint32_t) {
    this->drawn_.take_back(before.touched_count, this->counters_.touched_count);
    step.after = this->counters_ = before;
}

template <int D>
std::size_t OrderRun<D>::memory_bytes() const {
    return primitives_.capacity() * sizeof(std::uint32_t) + shown_.capacity() + nearest_.memory_bytes() +
           this->drawn_.memory_bytes();
}

template <int D>
std::uint64_t OrderRun<D>::hash() const {
    Hash hash;
    // Of a form with traversals of cells: every cell is clean.
    for (std::uint32_t cell = 0; cell < this->problem_.cells->cell_count(); ++cell) add_mark(hash, {});
    add_run(hash, *this);
    return hash.value();
}

template <int D>
Misses OrderRun<D>::misses() const {
    return this->counters_.offset >= count_ ? order_.promise : Misses::may;
}

template <int D>
Verdict OrderRun<D>::why_not(const Item& item) const {
    if (item.kind != Kind::cell) return {};
    return {"no-cells", "the method orders primitives, not cells"};
}

template <int D>
std::vector<CodeLine> OrderRun<D>::code(const CodePlace& at) const {
    const Counters& counters = this->counters_;
    const bool in_step = at.in_step(), popping = in_step && *at.substep == 0, rendering = in_step && !popping;
    std::vector<CodeLine> lines;
    lines.push_back({std::string(order_.code), 0, false, {}, std::string(order_.source)});
    lines.back().values = count_ == 0 && !order_.when_empty.empty() ? std::string(order_.when_empty)
                                                                    : std::to_string(count_) + " primitives";
    lines.push_back({"while some are left:", 0, !in_step && counters.spent < this->problem_.budget, {}, {}});
    if (!in_step) lines.back().values = std::to_string(count_ - counters.offset) + " left";
    lines.push_back({order_.batch == 1 ? "take the next one" : "take the next " + std::to_string(order_.batch),
                     1,
                     popping,
                     {},
                     {}});
    if (in_step)
        lines.back().values = (order_.batch == 1 ? "number " : "from number ") +
                              std::to_string(std::size_t{at.number - 1} * order_.batch + 1) + " of the order";
    lines.push_back({order_.batch == 1 ? "render it"
                     : order_.culls    ? "render those in view"
                                       : "render them",
                     1,
                     rendering,
                     {},
                     {}});
    if (rendering)
        lines.back().values = std::to_string(at.rendered) + (at.rendered == 1 ? " primitive" : " primitives");
    lines.push_back(budget_line(*this, 1, "", popping, in_step));
    lines.back().source.clear();
    return lines;
}

template class OrderRun<2>;
template class OrderRun<3>;

}  // namespace sightline
