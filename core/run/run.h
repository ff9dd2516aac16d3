// One execution of a method on a problem. It owns its state, goes forward, and explains itself; what measures, draws
// and steps knows nothing else of a method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "core/base/hash.h"
#include "core/run/explanation.h"
#include "core/run/problem.h"
#include "core/run/recorder.h"
#include "core/run/room_seen.h"
#include "core/space/levels.h"

namespace sightline {

enum class Direction : std::uint8_t { back, forward };

template <int D>
class Run;

/// A number that each item of a run may have: conditions, heat maps and traces reach it by its name.
template <int D>
struct Field {
    std::string_view name;   ///< as conditions write it
    std::string_view title;  ///< on scales
    std::string_view help;
    std::optional<double> (*read)(const Run<D>&, const Item&);  ///< of the run that the work is left to

    /// Nothing where the item has none.
    std::optional<double> value(const Run<D>& run, const Item& item) const { return read(run.worker(), item); }
};

/// A method implements run, clone, hash and finished; the rest has an answer that is right for any method, if a plain
/// one: it undoes by keyframes and says what was popped.
template <int D>
class Run {
public:
    explicit Run(const Problem<D>& problem)
        : problem_(problem),
          culled_costs_(problem.parameters.template choice<CulledCost>(culled_cost_row()) == CulledCost::charged) {
        drawn_.begin(problem.primitives().size());
    }
    virtual ~Run() = default;
    Run& operator=(const Run&) = delete;

    // Going forward.
    /// At most `steps` steps: one, n and all of them are the same code. Stop::steps when all were made, else why not.
    /// Without a recorder a step costs nothing extra.
    virtual Stop run(std::uint32_t steps, Recorder* recorder = nullptr) = 0;
    /// Whether it ends here: run() would say why.
    virtual bool finished() const = 0;
    /// Begins anew on another problem with the memory that it has; false: it cannot, start one. The method is the
    /// same, the parameters need not be.
    virtual bool restart(const Problem<D>&) { return false; }
    /// A larger budget goes on where a smaller one ended.
    virtual void set_budget(std::uint32_t budget) { problem_.budget = budget; }

    // Going back and forth in what was recorded.
    /// False: move() never succeeds, so that going back needs a keyframe.
    virtual bool undoes_by_marks() const { return false; }
    /// Undoes the last step, or does the next one again without computing anything: exchanges its marks with those of
    /// the changes. `before` are the counters before the step. False when it cannot; then nothing is changed.
    virtual bool move(Direction, const Step&, std::span<Change>, const Counters& /*before*/) { return false; }
    /// The parts that the last step can be shown in; 1: only whole.
    virtual std::uint32_t substeps(const Step&, std::span<const Change>) const { return 1; }
    /// On a clone that stands after the step: takes back what comes after the substep, and gives what the recording
    /// says of it the same state. Only where substep + 1 < substeps().
    virtual void rewind_to(Step&, std::vector<Change>& /*of the step*/, const Counters& /*before*/,
                           std::uint32_t /*substep*/) {}
    virtual std::unique_ptr<Run> clone() const = 0;
    virtual std::size_t memory_bytes() const = 0;

    // What it is.
    /// 64 bits over all that decides: marks, primitives met, counters; no heap layout, no time.
    virtual std::uint64_t hash() const = 0;
    virtual Mark mark(const Item&) const { return {}; }
    Mark mark(std::uint32_t cell) const { return mark(cell_item(cell)); }
    /// Whether what it found hidden (CellState::hidden) waits until the front is empty; false: it is dropped.
    virtual bool postpones() const { return false; }
    /// The size of the image that it decides by.
    virtual ImageSize deciding_size() const { return problem_.services.image; }
    /// Primitives that this image shows, though they may not be rendered yet.
    virtual std::span<const std::uint32_t> drawn_ahead() const { return {}; }
    /// The items that wait, first to last.
    virtual std::vector<std::pair<Item, Mark>> front() const { return {}; }
    /// Those in the front at the start, first to last.
    virtual std::span<const Item> seeds() const { return {}; }
    virtual Misses misses() const { return Misses::may; }
    /// Of a run that completes its picture after a first phase: how many were met in that; none: it is not complete so
    /// far, or never does.
    virtual std::uint32_t met_before_completing() const { return none; }
    /// How many times it asked an image, or occluders, whether something can be seen; not what the view alone decides.
    virtual std::uint64_t tests() const { return 0; }
    /// What this frame leaves to the next; nullptr: nothing.
    virtual std::shared_ptr<const FrameHistory> next_history() const { return nullptr; }

    // What it says of itself.
    virtual std::string_view rule_words(std::uint8_t /*rule*/) const { return {}; }
    /// All that a step looked at, in order, of a run that stands at that step or later.
    virtual std::vector<Considered> considered(const Step& step, std::span<const Change> changes, int digits) const {
        std::vector<Considered> all;
        for (const Change& change : changes) {
            Considered& c = all.emplace_back();
            c.from = step.item;
            c.item = change.item();
            c.rule = change.rule;
            c.words = rule_words(change.rule);
            c.effect = Effect::changed;
            c.before = change.mark();
            if (c.before.state == CellState::clean) c.key = key_terms(c.item, digits);
        }
        return all;
    }
    /// The key that an item has, where it comes from the item alone; nothing: it does not, or the item has none.
    virtual std::optional<KeyExplanation> key_terms(const Item&, int /*digits*/) const { return std::nullopt; }
    /// How a step speaks of what it popped; only for methods that pop other things than cells.
    virtual std::string popped_words(const Step& step) const {
        return step.item ? item_name(step.item) : "a batch of primitives in the method's order";
    }
    /// Why an item has not come into the front; empty: it has, or there is nothing to say.
    virtual Verdict why_not(const Item&) const { return {}; }
    /// Why an item was drawn, and what it would have taken to cull it; empty: there is nothing to say.
    virtual Verdict why_drawn(const Item&) const { return {}; }
    /// What else than its key keeps an item in the front; empty: nothing does.
    virtual Verdict why_waiting(const Item&) const { return {}; }
    virtual std::vector<CodeLine> code(const CodePlace&) const { return {}; }
    virtual std::span<const Field<D>> fields() const { return {}; }
    /// What is drawn in place of objects: those that are not named here are drawn as they are. Rising by object.
    virtual std::span<const StandIn> stand_ins() const { return {}; }
    /// The levels that stand_ins() names; nullptr: there never are any.
    virtual std::shared_ptr<const Levels<D>> levels() const { return nullptr; }
    /// All tiles of the image, row by row; empty where none was read so far.
    virtual std::vector<ReadTile> tiles() const { return {}; }
    /// The tree whose boxes it walks; nullptr: it walks none.
    virtual const BoxTree<D>* boxes() const { return nullptr; }
    /// Whether planes between occluders and boxes decide: what follows has something to say.
    virtual bool tests_planes() const { return false; }
    /// Those that may hide something, largest first; empty for methods that choose none.
    virtual std::vector<OccluderFact> occluders() const { return {}; }
    /// The planes between a box and the occluder of a primitive (none: the one that hides most of it); empty where the
    /// two were not tested.
    virtual std::vector<TestedPlane<D>> tested_planes(const Item& /*box*/, std::uint32_t /*primitive*/) const {
        return {};
    }
    /// Those that the box was tested against, largest first; empty for one that lies outside the view.
    virtual std::vector<TestedOccluder> tested_occluders(const Item& /*box*/) const { return {}; }
    /// The leaf of space that holds the eye; nothing: it is in none.
    virtual std::optional<Box<D>> eye_box() const { return std::nullopt; }
    /// Of the polygon of a primitive; nothing: it never is one.
    virtual std::optional<OccluderRegion<D>> occluder_region(std::uint32_t /*primitive*/) const { return std::nullopt; }

    /// Of a method that goes from room to room, in the order of its steps, in a scene that has some; nothing: it does
    /// not.
    virtual std::optional<std::vector<RoomSeen<D>>> rooms_seen() const { return std::nullopt; }
    /// Of a method that chooses a technique by viewpoint.
    virtual std::optional<ViewpointFact<D>> viewpoint() const { return std::nullopt; }

    const Problem<D>& problem() const { return problem_; }
    /// The run that it leaves the work to, which meets primitives and counts them; itself where it does that.
    virtual const Run& worker() const { return *this; }
    const Counters& counters() const { return worker().counters_; }
    virtual std::uint32_t steps() const { return steps_; }  ///< taken
    const Drawn& drawn() const { return worker().drawn_; }
    /// What a recording of its steps met beyond what it has met itself.
    virtual void remember(std::span<const Met> all) { drawn_.remember(all); }
    /// What was met so far.
    std::span<const Met> met() const { return drawn().all().first(counters().touched_count); }

protected:
    Run(const Run&) = default;

    /// Empties all for another problem.
    void begin(const Problem<D>& problem) {
        problem_ = problem;
        culled_costs_ = problem.parameters.template choice<CulledCost>(culled_cost_row()) == CulledCost::charged;
        drawn_.begin(problem.primitives().size());
        counters_ = {};
        steps_ = 0;
    }
    /// What undo and redo do in all runs: to the primitives met, the counters and the number of steps.
    void move_met(Direction direction, const Step& step, const Counters& before) {
        if (direction == Direction::back) {
            drawn_.take_back(before.touched_count, counters_.touched_count);
            --steps_;
            counters_ = before;
        } else {
            drawn_.put_back(counters_.touched_count, step.after.touched_count);
            ++steps_;
            counters_ = step.after;
        }
    }
    bool meet(std::uint32_t primitive, bool culls) {
        return sightline::meet(problem_, culled_costs_, primitive, culls, drawn_, counters_);
    }

    Problem<D> problem_;  ///< as it was given; only the budget changes
    bool culled_costs_;
    Drawn drawn_;
    Counters counters_;
    std::uint32_t steps_ = 0;
};

/// Significant digits that tell the key of what a step popped from the runner-up's.
int digits_of(const Step& step);

/// "stop when the budget is used up", lit between two steps where it is. `popping`: what the step at hand will spend is
/// not spent yet.
template <int D>
CodeLine budget_line(const Run<D>& run, int indent, std::string_view more, bool popping, bool in_step);

/// Parts of a run's hash.
inline void add_mark(Hash& hash, const Mark& mark) {
    hash.add(mark.key);
    hash.add(static_cast<std::uint64_t>(mark.stamp) << 8 | static_cast<std::uint64_t>(mark.state));
}
template <int D>
void add_run(Hash& hash, const Run<D>& run) {
    for (const Met entry : run.met()) hash.add(entry.bits());
    const Counters& c = run.counters();
    for (const std::uint32_t count : {c.touched_count, c.rendered_count, c.spent, c.front_size, c.next_stamp,
                                      run.steps(), c.partial_cell, c.offset})
        hash.add(count);
    if (run.problem().history) hash.add(run.problem().history->hash());
}

/// A run as a value: a copy is a clone.
template <int D>
class OwnRun {
public:
    OwnRun() = default;
    OwnRun(std::unique_ptr<Run<D>> run) : run_(std::move(run)) {}
    OwnRun(const OwnRun& other) : run_(other.run_ ? other.run_->clone() : nullptr) {}
    OwnRun(OwnRun&&) noexcept = default;
    OwnRun& operator=(OwnRun other) noexcept {
        run_ = std::move(other.run_);
        return *this;
    }

    /// Starts anew on a problem: in the run's own memory where it can, else in a run that `make(problem)` makes.
    template <typename Make>
    void start(const Problem<D>& problem, const Make& make) {
        if (!run_ || !run_->restart(problem)) run_ = make(problem);
    }

    explicit operator bool() const { return run_ != nullptr; }
    Run<D>& operator*() { return *run_; }
    const Run<D>& operator*() const { return *run_; }
    Run<D>* operator->() { return run_.get(); }
    const Run<D>* operator->() const { return run_.get(); }

private:
    std::unique_ptr<Run<D>> run_;
};

}  // namespace sightline
