// What a walk over boxes says of itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/box_run.h"

#include "core/base/text.h"
#include "core/run/box_key.h"
#include "core/run/opened_to.h"

namespace sightline {

namespace {

bool is_own(const Step& step, const Change& change) { return change.item() == step.item; }

}  // namespace

template <int D>
std::string BoxRun<D>::popped_words(const Step& step) const {
    return step.item ? Run<D>::popped_words(step) : "a batch of occluders";
}

template <int D>
Verdict BoxRun<D>::why_not(const Item& item) const {
    if (item.kind == Kind::cell) return {"no-cells", "the method walks a tree of boxes, not cells"};
    if (item.kind != Kind::node) return {};
    const CellState state = marks_[item.id].state;
    if (state == CellState::unseen) return {"outside-view", "it covers no pixel of the view"};
    if (state == CellState::hidden) {
        Screen<D> screen;
        screen.show(this->problem_, this->met(), this->counters_.refreshed, opacity_);
        const SeenPart seen = screen.part_of(this->problem_, tree_->nodes[item.id].box);
        return {"hidden", "it is hidden: " + counted(seen.pixels, "pixel") + " of it, behind " +
                              some_of(D == 2 ? "segment" : "triangle", seen.hidden_by, most_hiders)};
    }
    if (state != CellState::clean) return {};
    const std::uint32_t above = opened_to(*tree_, marks_, item.id);
    const Item box{above, Kind::node};
    switch (marks_[above].state) {
        case CellState::unseen:
            return {"outside-view", "it lies in " + item_name(box) + ", which covers no pixel of the view", box};
        case CellState::hidden:
            return {"hidden", "it lies in " + item_name(box) + ", which is hidden", box};
        case CellState::enqueued:
            return {"waits", "it lies in " + item_name(box) + ", which waits", box};
        default:
            return {"drawn-whole", "it lies in " + item_name(box) + ", which is drawn as a whole", box};
    }
}

template <int D>
std::optional<KeyExplanation> BoxRun<D>::key_terms(const Item& item, int digits) const {
    if (item.kind != Kind::node) return std::nullopt;
    const typename BoxTree<D>::Node& at = tree_->nodes[item.id];
    if (tests_depth()) return explain_box_key(squared_distance(at.box, this->problem_.view.eye), std::nullopt, digits);
    KeyExplanation e;
    e.key = at.begin;
    e.parts = {{"key = place in the tree = " + std::to_string(at.begin)}};
    e.tip = "boxes come as the tree holds them";
    e.weightiest = "its place in the tree";
    e.terms = {{"key", e.key, {}}};
    return e;
}

template <int D>
std::vector<CodeLine> BoxRun<D>::code(const CodePlace& at) const {
    const Counters& counters = this->counters_;
    const bool in_step = at.in_step(), testing = in_step && *at.substep == 0;
    const bool pops = at.step && at.step->item.kind == Kind::node;
    BoxRule rule = BoxRule::enqueued;
    for (const Change& change : at.changes)
        if (at.step && is_own(*at.step, change)) rule = BoxRule{change.rule};
    const std::string popped = pops ? item_name(at.step->item) : "";
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values = {}, std::string source = {}) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), std::move(source)});
    };
    if (!occluders_.empty() || (tests_depth() && method_.occluders != Occluders::none))
        add("draw the occluders", 0, (in_step && !pops) || (!in_step && this->steps_ < occluder_steps()),
            in_step ? counted(at.rendered, "occluder") : counted(occluders_.size(), "occluder"),
            method_.test == BoxMethod::Test::opacity ? "Zhang et al. 1997, section 3" : "");
    if (method_.test != BoxMethod::Test::view && !tests_depth())
        add("so little is in view that drawing all of it is cheaper: test nothing", 0, false);
    add("while a box waits:", 0, !in_step && this->steps_ >= occluder_steps() && counters.spent < this->problem_.budget,
        counters.front_size == 1 ? "1 box waits" : std::to_string(counters.front_size) + " boxes wait");
    add(tests_depth() ? "take the nearest one" : "take the next one", 1, testing, popped,
        method_.test == BoxMethod::Test::pixels ? "Greene et al. 1993, section 3.1" : "");
    if (in_step && pops) lines.back().values = popped + ", " + key_terms(at.step->item, digits_of(*at.step))->sum();
    add("outside the view: drop it", 1, in_step && !testing && rule == BoxRule::outside, popped);
    if (tests_depth())
        add(method_.test == BoxMethod::Test::pixels ? "no pixel of it lies before what is drawn: drop it"
            : is_fixed()                            ? "its rectangle lies behind the occluders: drop it"
                                                    : "its rectangle lies behind what is drawn: drop it",
            1, in_step && !testing && rule == BoxRule::hidden, popped + " is hidden");
    add("it has halves: put them into the front", 1, in_step && !testing && rule == BoxRule::opened, popped);
    add(wins_pixels()    ? "else draw its primitives that win a pixel"
        : !tests_depth() ? "else, or when all of it is in view, draw its primitives"
                         : "else draw its primitives in view",
        1, in_step && !testing && rule == BoxRule::drawn, counted(at.rendered, "primitive") + " of " + popped);
    lines.push_back(budget_line(*this, 1, "", testing, in_step));
    lines.back().source.clear();
    return lines;
}

#define SIGHTLINE_INSTANTIATE(D)                                                         \
    template std::string BoxRun<D>::popped_words(const Step&) const;                     \
    template Verdict BoxRun<D>::why_not(const Item&) const;                              \
    template std::optional<KeyExplanation> BoxRun<D>::key_terms(const Item&, int) const; \
    template std::vector<CodeLine> BoxRun<D>::code(const CodePlace&) const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
