// A walk over the tree of boxes, nearest first: boxes out of view or hidden are dropped, the others opened or drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/methods/image_space/image_parameters.h"
#include "core/run/front.h"
#include "core/run/marks.h"
#include "core/run/method.h"
#include "core/run/screen.h"
#include "core/space/box_tree.h"

namespace sightline {

/// Change::rule.
enum class BoxRule : std::uint8_t {
    enqueued,  ///< a half of the popped box: now in the front
    outside,   ///< the popped box: covers no pixel of the view
    hidden,    ///< the popped box: nothing in it lies before what is drawn
    opened,    ///< the popped box: its halves come into the front
    drawn,     ///< the popped box: its primitives are drawn
};
inline constexpr auto box_rule_words = std::to_array<std::string_view>(
    {"enqueued", "outside the view", "hidden", "may be seen: opened", "may be seen: drawn"});

/// What tells the methods of the family apart.
struct BoxMethod {
    enum class Test : std::uint8_t {
        view,     ///< none: what is in view is drawn
        depth,    ///< by its rectangle, against the farthest depths of what is drawn, refreshed now and then
        pixels,   ///< face by face and down to single pixels, against all that is drawn
        fixed,    ///< by its rectangle, against the farthest depths of the occluders
        opacity,  ///< the same where blocks of pixels are opaque enough
    };
    Test test = Test::depth;
    Occluders occluders = Occluders::none;
    Draws draws = Draws::winners;
};

/// Its items are nodes of the tree. Their keys are the squared distances of the boxes from the eye; for view culling
/// their places in the tree. A leaf of which the budget left something is Counters::partial_cell.
template <int D>
class BoxRun final : public Run<D> {
public:
    using Run<D>::mark;
    /// The start of the method that picks occluders for occluders=plp.
    using Picker = std::function<std::unique_ptr<Run<D>>(const Problem<D>&)>;

    BoxRun(const Problem<D>& problem, const BoxMethod& method, Picker picker);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    bool undoes_by_marks() const override { return true; }
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override { return 2; }
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<BoxRun>(*this); }
    std::size_t memory_bytes() const override;
    std::uint64_t hash() const override;
    Mark mark(const Item& item) const override { return item.kind == Kind::node ? marks_[item.id] : Mark{}; }
    std::vector<std::pair<Item, Mark>> front() const override;
    Misses misses() const override;
    std::shared_ptr<const FrameHistory> next_history() const override;
    const BoxTree<D>* boxes() const override { return tree_; }
    /// Boxes, against depths.
    std::uint64_t tests() const override {
        return tests_depth() && this->steps_ > occluder_steps() ? this->steps_ - occluder_steps() : 0;
    }

    std::string_view rule_words(std::uint8_t rule) const override { return box_rule_words[rule]; }
    std::string popped_words(const Step&) const override;
    Verdict why_not(const Item&) const override;
    std::optional<KeyExplanation> key_terms(const Item&, int digits) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;

private:
    /// Occluders of a step.
    static constexpr std::uint32_t batch = 32;
    void begin_boxes();
    std::uint32_t occluder_steps() const { return (static_cast<std::uint32_t>(occluders_.size()) + batch - 1) / batch; }
    /// Counters::partial_cell when the budget ended among the occluders.
    std::uint32_t occluders_left() const { return static_cast<std::uint32_t>(tree_->nodes.size()); }
    bool tests_depth() const { return tests_depth_; }
    bool are_worth_testing(double worth) const;
    bool wins_pixels() const { return tests_depth() && all_winners_; }

    Stop next(Recorder*);
    void meet_occluders();
    void pop(const Front::Entry& entry, Recorder*);
    BoxSight sight_of(std::uint32_t node, bool& whole);
    /// The image stays that of the occluders.
    bool is_fixed() const { return method_.test == BoxMethod::Test::fixed || method_.test == BoxMethod::Test::opacity; }
    void enqueue(std::uint32_t node, Recorder*);
    const Front::Entry* front_top();
    void sync();
    void refresh_if_due();
    /// Appends what is drawn of the node, or may be.
    void collect(std::uint32_t node, bool whole, std::vector<std::uint32_t>& found);
    bool is_drawn(std::uint32_t primitive, SideSeen facing, bool whole) const;
    /// Draws what waits to be drawn; the budget has place for all of it.
    void draw_waiting();
    /// Draws the rest of a box one by one, until the budget ends; false: it did.
    bool draw_slowly(std::uint32_t node);

    BoxMethod method_;
    Picker picker_;
    const BoxTree<D>* tree_ = nullptr;
    bool tests_depth_ = true;
    bool all_winners_ = true;  ///< draws=winners
    std::uint32_t refresh_ = 1;
    double opacity_ = 1;
    Marks marks_;
    Front front_;
    bool front_is_stale_ = false;
    std::vector<std::uint32_t> occluders_;  ///< in their order
    Screen<D> screen_;
    std::vector<std::uint32_t> waiting_;  ///< primitives of popped boxes; empty between two calls of run()
    std::vector<SideSeen> facing_;        ///< scratch
};

extern template class BoxRun<2>;
extern template class BoxRun<3>;

}  // namespace sightline
