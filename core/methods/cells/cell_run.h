// The traversal: RenderingLoop of TVCG fig. 4 (TR fig. 5) with a heuristic for the keys. One step is one pop; one, n
// or all steps run the same code.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/number.h"
#include "core/methods/cells/cell_base.h"
#include "core/methods/cells/seen_before.h"
#include "core/space/cell_in_view.h"

namespace sightline {

/// What a heuristic computes. A plain number is a key without a penalty.
struct Key {
    double value = 0;
    bool penalty = false;
    Key(double key, bool has_penalty = false) : value(key), penalty(has_penalty) {}
};

namespace detail {

/// Sinks of the traversal: one that records, and one that is compiled away.
struct RecordingSink {
    static constexpr bool enabled = true;
    Recorder& recorder;
};
struct NoSink {
    static constexpr bool enabled = false;
};

}  // namespace detail

/// A heuristic has three members: the key of the seed cell, what happens to a cell in the front that is reached again,
/// and the key of a cell:
///     static constexpr double seed_key;
///     static constexpr OnReenqueue on_reenqueue;   // or a member, where a parameter says it
///     template <int D>
///     Key key(const Problem<D>&, std::uint32_t a, double key_a, const HalfFacet& half) const;
/// `a` was just projected with key `key_a`; `half` is its facet towards the cell that gets the key. The heuristic is
/// made from the problem where it has such a constructor. Where more than cell `a` decides, key and explain take the
/// marks and CellsInView in place of `key_a`, behind the problem, light() has keeps() (transmittance.h), and
///     static constexpr bool stamps_pops = true;
/// lets stamps say which cells were projected before `a`. One that starts in its own way has
///     static constexpr Seeds seeds;
///     static constexpr bool from_seen = true;      // and from cells_seen_before()
/// and one whose primitives wait until their turn comes, among those of other cells, has `waiting` and add_waiting
/// (transmittance/tri.h). It may say more of itself (plp/published.h is the model):
///     KeyExplanation explain(problem, a, key_a, half, digits) const;
///     void add_key_lines(std::vector<CodeLine>&, const KeyExplanation*, int digits) const;
///     static constexpr std::string_view key_title;
/// and have, where that takes less time than key() and is the same to the last bit,
///     double key_value(problem, a, key_a, half) const;
/// and ask ahead for what the key of a cell needs:
///     void prefetch(problem, cell) const;
template <int D, typename Heuristic>
class CellRun final : public CellBase<D> {
public:
    explicit CellRun(const Problem<D>& problem) : CellBase<D>(problem), heuristic_(made_from(problem)) {
        if (waits) this->parameters_.neighbours_before_break = YesNo::no;
        this->begin_cells(heuristic_.seed_key, start_from(), from_seen);
    }
    /// With a heuristic that holds something of its own, such as a function of a script, and so has
    ///     void begin(const Problem<D>&);   // of the problem that it is asked about from now on
    CellRun(const Problem<D>& problem, Heuristic heuristic) : CellBase<D>(problem), heuristic_(std::move(heuristic)) {
        heuristic_.begin(problem);
        this->begin_cells(heuristic_.seed_key, start_from(), from_seen);
    }

    bool restart(const Problem<D>& problem) override {
        if (this->rounds_) return false;  // another first method may be wanted
        this->begin(problem);
        this->parameters_ = CellParameters(problem.parameters);
        if (waits) this->parameters_.neighbours_before_break = YesNo::no;
        if constexpr (requires { heuristic_.begin(problem); })
            heuristic_.begin(problem);
        else
            heuristic_ = made_from(problem);
        this->begin_cells(heuristic_.seed_key, start_from(), from_seen);
        return true;
    }

    Stop run(std::uint32_t steps, Recorder* recorder) override {
        return with_sink(recorder, [&](auto sink) { return loop(steps, sink); });
    }

    std::shared_ptr<const FrameHistory> next_history() const override {
        if constexpr (from_seen) return cells_that_show(this->problem_, this->marks_, this->met());
        return nullptr;
    }

    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<CellRun>(*this); }

    std::span<const Field<D>> fields() const override {
        static const auto table = std::to_array<Field<D>>(
            {{"rho", key_title(), "the key of the cell",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  const Mark mark = run.mark(item);
                  if (mark.state != CellState::enqueued && mark.state != CellState::projected) return std::nullopt;
                  return mark.key;
              }},
             {"count", "primitives in the cell |A|", "|A|, the primitives in the cell",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  if (item.kind != Kind::cell) return std::nullopt;
                  return run.problem().cells->count(item.id);
              }},
             {"round", "round", "the round of cPLP that projected the cell; 0: none did",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  if (run.mark(item).state != CellState::projected) return std::nullopt;
                  return static_cast<const CellRun&>(run).rounds_->round_of[item.id];
              }},
             {"hidden", "hidden", "1 where a round of cPLP found the cell hidden, 0 where it did not test it or saw it",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  if (run.mark(item).state != CellState::enqueued) return std::nullopt;
                  return static_cast<const CellRun&>(run).rounds_->hidden[item.id];
              }},
             {"bytes_read", "bytes read", "of a round of cPLP: ids read in tiles that still show one",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  return static_cast<const CellRun&>(run).bytes_read(item, false);
              }},
             {"bytes_whole", "bytes of the image", "of a round of cPLP: ids read without tiles",
              [](const Run<D>& run, const Item& item) -> std::optional<double> {
                  return static_cast<const CellRun&>(run).bytes_read(item, true);
              }}});
        const bool ids = this->rounds_ && this->rounds_->form.test == FrontTest::item;
        return std::span<const Field<D>>(table).first(ids ? 6 : this->rounds_ ? 4 : 2);
    }

private:
    static constexpr bool waits = requires(Heuristic h) { h.waiting; };
    static constexpr bool by_light = requires(const Heuristic h) { h.light(); };
    static constexpr bool from_seen = requires { Heuristic::from_seen; };
    static constexpr std::uint32_t waiting_batch = 32, fetched_ahead = 12;

    static Heuristic made_from(const Problem<D>& problem) {
        if constexpr (std::is_constructible_v<Heuristic, const Problem<D>&>)
            return Heuristic(problem);
        else
            return Heuristic{};
    }
    Seeds start_from() const {
        if constexpr (requires { Heuristic::seeds; })
            return Heuristic::seeds;
        else
            return this->problem_.parameters.template choice<Seeds>(seeds_row());
    }
    static constexpr std::string_view key_title() {
        if constexpr (requires { Heuristic::key_title; })
            return Heuristic::key_title;
        else
            return "key";
    }

    template <typename Use>
    static auto with_sink(Recorder* recorder, Use use) {
        return recorder ? use(detail::RecordingSink{*recorder}) : use(detail::NoSink{});
    }

    template <typename Sink>
    Stop loop(std::uint32_t steps, Sink sink) {
        const std::uint64_t end = std::uint64_t{this->steps_} + steps;
        while (this->steps_ < end)
            if (const Stop stop = step(sink); stop != Stop::none) return stop;
        return Stop::steps;
    }

    /// One pop, or the rest of the cell that the budget left partly rendered. Stop::none when a step was made.
    template <typename Sink>
    Stop step(Sink& sink) {
        Counters& counters = this->counters_;
        std::uint32_t cell = counters.partial_cell;
        if (counters.spent >= this->problem_.budget || (this->rounds_ && this->rounds_->done > 0))
            return round_or(Stop::budget, sink);
        if constexpr (waits)
            if (this->front_is_stale_) rebuild_waiting();
        if (cell == none) {
            const Front::Entry* top = this->front_top();
            if constexpr (waits)
                if (!top) return render_batch(sink);
            if (!top) return round_or(Stop::front_empty, sink);
            cell = top->id;
            Mark mark{top->key, top->stamp, CellState::projected};
            this->front_.pop();
            --counters.front_size;
            this->marks_.set(cell, mark);
            ++this->steps_;
            this->contents_.prefetch_contents(*this->problem_.cells, cell);
            prefetch_step(cell);
            if constexpr (Sink::enabled) {
                const Front::Entry* next = this->front_top();
                sink.recorder.popped(cell_item(cell), mark, next ? cell_item(next->id) : Item{}, next ? next->key : 0);
            }
            if (stamps_pops()) {
                mark.stamp = counters.next_stamp++;
                this->marks_.set(cell, mark);
            }
        }
        go_on_with(cell, sink);
        if constexpr (Sink::enabled) sink.recorder.finished(counters);
        return Stop::none;
    }

    template <typename Sink>
    Stop round_or(Stop stop, Sink& sink) {
        if (!this->rounds_) return stop;
        if constexpr (Sink::enabled)
            return this->make_round(&sink.recorder);
        else
            return this->make_round(nullptr);
    }

    void project_now(std::uint32_t cell, Recorder* recorder) override {
        Mark mark = this->marks_[cell];
        if (recorder) recorder->changed(cell_item(cell), mark, static_cast<std::uint8_t>(Rule::projected_now));
        mark.state = CellState::projected;
        if (stamps_pops()) mark.stamp = this->counters_.next_stamp++;
        this->marks_.set(cell, mark);
        --this->counters_.front_size;
        this->counters_.offset = 0;
        bool done = true;  // or the total is spent
        if (this->rounds_->form.only_winners)
            for (const std::uint32_t primitive : this->rounds_->winners) done = done && this->meet(primitive, false);
        else
            done = project(cell);
        if (done) this->counters_.offset = 0;
        if (!done) this->counters_.partial_cell = cell;
        if (done || this->parameters_.neighbours_before_break == YesNo::yes)
            with_sink(recorder, [&](auto sink) { add_neighbours(cell, sink); });
    }
    void finish_partial(Recorder* recorder) override {
        with_sink(recorder, [&](auto sink) { go_on_with(this->counters_.partial_cell, sink); });
    }

    /// Projects the popped or partly rendered cell and adds its neighbours, as far as the budget allows.
    template <typename Sink>
    void go_on_with(std::uint32_t cell, Sink& sink) {
        Counters& counters = this->counters_;
        if constexpr (waits) {
            prefetch_next(cell);
            const bool rendered =
                render_waiting(heuristic_.waiting.class_of(static_cast<float>(this->marks_[cell].key)), none);
            counters.partial_cell = rendered ? none : cell;
            if (!rendered) return;
            heuristic_.add_waiting(this->problem_, this->contents_, cell, this->marks_[cell].key);
            add_neighbours(cell, sink);
            return;
        }
        const bool resumed = counters.partial_cell == cell;
        const bool neighbours_first = this->parameters_.neighbours_before_break == YesNo::yes;
        if (neighbours_first && !resumed) add_neighbours(cell, sink);  // first, while what the cell holds is fetched
        prefetch_next(cell);
        const bool done = project(cell);
        // "no" is the papers' break: the budget ends the loop before the neighbours, even at the end of a cell.
        const bool broken = neighbours_first ? !done : counters.spent >= this->problem_.budget;
        if (!neighbours_first && !broken) add_neighbours(cell, sink);
        counters.partial_cell = broken ? cell : none;
        if (!broken) counters.offset = 0;
    }

    // Of a heuristic whose primitives wait: those that come before the popped cell are rendered with it, and those that
    // it holds wait from then on.

    /// The first that was not met by way of another cell, where its class comes before `end`; empty: there is no such.
    auto first_waiting(std::uint32_t end) const {
        auto first = heuristic_.waiting.first(end);
        for (; first; first = heuristic_.waiting.first(end)) {
            if (!this->drawn_.has(this->problem_.cells->cell_primitives[first.place()])) break;
            heuristic_.waiting.drop_first();
        }
        return first;
    }
    /// Renders at most `count` of those whose class comes before `end`; false where the budget ends it.
    bool render_waiting(std::uint32_t end, std::uint32_t count) {
        const CellComplex<D>& cells = *this->problem_.cells;
        for (; count > 0; --count) {
            const auto first = first_waiting(end);
            if (!first) break;
            if (const auto ahead = heuristic_.waiting.behind_first(fetched_ahead))
                detail::prefetch(&cells.cell_primitives[ahead.place()]);
            if (const auto next = heuristic_.waiting.behind_first(fetched_ahead / 2))
                detail::prefetch(this->drawn_.address_of(cells.cell_primitives[next.place()]));
            const bool met = first.shows()
                                 ? add_met(this->problem_.budget, this->culled_costs_,
                                           {cells.cell_primitives[first.place()], false}, this->drawn_, this->counters_)
                                 : this->contents_.meet_one(this->problem_, this->culled_costs_,
                                                            this->contents_.held_at(cells, first.place()), this->drawn_,
                                                            this->counters_);
            if (!met) return false;
            heuristic_.waiting.drop_first();
        }
        return true;
    }
    /// When no cell is left: a batch of those that still wait, or the rest of one.
    template <typename Sink>
    Stop render_batch(Sink& sink) {
        Counters& counters = this->counters_;
        if (!this->more_waits()) return Stop::front_empty;
        if (counters.offset % waiting_batch == 0) {
            ++this->steps_;
            if constexpr (Sink::enabled) sink.recorder.popped({}, {});
        }
        do {
            if (!render_waiting(none, 1)) break;
            ++counters.offset;
        } while (counters.offset % waiting_batch != 0 && this->more_waits());
        if constexpr (Sink::enabled) sink.recorder.finished(counters);
        return Stop::none;
    }
    void rebuild_waiting() const {
        if constexpr (waits) {
            heuristic_.waiting.clear();
            for (std::uint32_t cell = 0; cell < this->marks_.size(); ++cell)
                if (const Mark mark = this->marks_[cell];
                    mark.state == CellState::projected && cell != this->counters_.partial_cell)
                    heuristic_.add_waiting(this->problem_, this->contents_, cell, mark.key);
        }
    }
    bool more_waits() const override {
        if constexpr (waits) {
            if (this->front_is_stale_) rebuild_waiting();
            return static_cast<bool>(first_waiting(none));
        } else {
            return false;
        }
    }

    /// fig. 4, line 3: renders from `offset` on. True when the cell is done, false when the budget ended inside it.
    bool project(std::uint32_t cell) {
        if (this->parameters_.budget_counts == BudgetCounts::per_cell) {
            project_whole(cell);
            return true;
        }
        return this->contents_.meet(this->problem_, this->culled_costs_, cell, this->drawn_, this->counters_);
    }

    /// The gem's project(): all of the cell, which counts as many primitives as it holds, whether they were met before
    /// or not, and none where it lies outside the view.
    void project_whole(std::uint32_t cell) {
        const auto primitives = this->problem_.cells->primitives_of(cell);
        Counters& counters = this->counters_;
        if (counters.offset == primitives.size()) return;  // nothing to render, or done before a break
        const std::uint32_t before = counters.spent;
        for (; counters.offset < primitives.size(); ++counters.offset) {
            counters.spent = 0;  // there is a budget left, so that one more is always met
            this->meet(primitives[counters.offset], true);
        }
        counters.spent = before;
        if (this->in_view_.has(*this->problem_.cells, this->problem_.view, cell,
                               this->problem_.cells->corners_of(cell)))
            counters.spent += static_cast<std::uint32_t>(primitives.size());
    }

    template <typename Sink>
    Key key_of(std::uint32_t a, double key_a, const HalfFacet& half) const {
        if constexpr (by_light)
            return heuristic_.key(this->problem_, this->marks_, this->in_view_, a, half);
        else if constexpr (!Sink::enabled && requires { heuristic_.key_value(this->problem_, a, key_a, half); })
            return heuristic_.key_value(this->problem_, a, key_a, half);
        else
            return heuristic_.key(this->problem_, a, key_a, half);
    }

    /// Whether to work out the key of a waiting cell again, behind facet i of the one just projected, would give the
    /// key that it has.
    bool keeps_key(std::uint32_t cell, std::size_t i, std::uint32_t n, const Mark& before) const {
        if constexpr (by_light)
            return before.key != heuristic_.seed_key && heuristic_.light().keeps(this->problem_, cell, i, n);
        return false;
    }

    /// fig. 4, lines 6-10.
    template <typename Sink>
    void add_neighbours(std::uint32_t cell, Sink& sink) {
        const CellComplex<D>& cells = *this->problem_.cells;
        const double key_a = this->marks_[cell].key;
        const auto facets = this->contents_.facets_of(cells, cell);
        std::array<std::uint32_t, 4> place;
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const HalfFacet& half = facets[i];
            const std::uint32_t n = half.neighbour;
            if (n == none) continue;
            const Mark before = this->marks_[n];
            if (before.state == CellState::projected || before.state == CellState::unseen) continue;
            Rule rule = Rule::kept;
            [[maybe_unused]] bool penalty = false;
            if (before.state == CellState::clean) {
                if (this->parameters_.outside_view == OutsideView::unseen &&
                    !this->in_view_.has(cells, this->problem_.view, n,
                                        this->contents_.corners_behind(cells, cell, i, place))) {
                    this->marks_.set(n, {0, 0, CellState::unseen});
                    rule = Rule::marked_unseen;
                } else {
                    this->contents_.prefetch_cell(cells, n);
                    const Key key = key_of<Sink>(cell, key_a, half);
                    this->enqueue(n, key.value, false);
                    rule = Rule::enqueued;
                    penalty = key.penalty;
                }
            } else if (heuristic_.on_reenqueue != OnReenqueue::never) {
                const OnReenqueue on = heuristic_.on_reenqueue;
                const Key key = keeps_key(cell, i, n, before) ? Key(before.key) : key_of<Sink>(cell, key_a, half);
                if (on == OnReenqueue::replace || (on == OnReenqueue::min && key.value < before.key) ||
                    (on == OnReenqueue::max && key.value > before.key)) {
                    this->enqueue(n, key.value, true);
                    rule = Rule::reenqueued;
                }
                penalty = key.penalty;
            }
            if constexpr (Sink::enabled)
                sink.recorder.changed(cell_item(n), before, static_cast<std::uint8_t>(rule), half.facet(), penalty);
        }
    }

    // The pops jump about in space, so that most of a step's time would go into waiting for memory, one row after the
    // other. The functions below ask for it ahead; they change nothing else.

    /// While the cell is projected: what those need that are likely to come next.
    void prefetch_next(std::uint32_t cell) const {
        const std::uint32_t next = this->front_.likely_next(0, cell);
        prefetch_step(next);
        this->contents_.prefetch_contents(*this->problem_.cells, next);
        prefetch_step(this->front_.likely_next(1, cell));
    }
    void prefetch_step(std::uint32_t cell) const {
        const CellComplex<D>& cells = *this->problem_.cells;
        for (const HalfFacet& half : this->contents_.facets_of(cells, cell)) {
            if (half.neighbour == none) continue;
            detail::prefetch(this->marks_.address_of(half.neighbour));
            if constexpr (requires { heuristic_.prefetch(this->problem_, half.neighbour); })
                heuristic_.prefetch(this->problem_, half.neighbour);
        }
    }

    KeyExplanation explain_key(std::uint32_t a, double key_a, const HalfFacet& half, int digits) const override {
        if constexpr (by_light) {
            return heuristic_.explain(this->problem_, this->marks_, this->in_view_, a, half, digits);
        } else if constexpr (requires { heuristic_.explain(this->problem_, a, key_a, half, digits); }) {
            return heuristic_.explain(this->problem_, a, key_a, half, digits);
        } else {
            const Key key = key_of<detail::RecordingSink>(a, key_a, half);
            KeyExplanation e;
            e.key = key.value;
            e.parts = {{"key = " + short_number(key.value, digits)}};
            e.weightiest = "its key, " + short_number(key.value, digits);
            e.terms = {{"handed_on", key_a, {}}, {"key", key.value, {}}};
            return e;
        }
    }
    bool stamps_pops() const override {
        if constexpr (requires { Heuristic::stamps_pops; })
            return Heuristic::stamps_pops;
        else
            return false;
    }
    std::string_view project_line() const override {
        return waits ? "render what waits and comes before c; what c holds waits from now on"
                     : "project c: render its primitives in view that are not rendered yet";
    }
    OnReenqueue reenqueue_rule() const override { return heuristic_.on_reenqueue; }
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const override {
        if constexpr (requires { heuristic_.add_key_lines(lines, explained, digits); }) {
            heuristic_.add_key_lines(lines, explained, digits);
        } else {
            lines.push_back({"key(n, c): the " + std::string(key_title()) + " of n behind c", 0, false, {}, {}});
            lines.push_back({"as the method computes it", 1, false, explained ? explained->sum() : std::string(), {}});
        }
    }

    Heuristic heuristic_;
};

}  // namespace sightline
