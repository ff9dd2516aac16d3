// What a walk over boxes with feedback says of itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/text.h"
#include "core/methods/feedback/feedback_run.h"
#include "core/run/box_key.h"
#include "core/run/opened_to.h"

namespace sightline {

template <int D>
std::string FeedbackRun<D>::popped_words(const Step& step) const {
    return step.item ? Run<D>::popped_words(step) : "a batch of what was postponed";
}

template <int D>
Verdict FeedbackRun<D>::why_not(const Item& item) const {
    if (item.kind == Kind::cell) return {"no-cells", "the method walks a tree of boxes, not cells"};
    if (item.kind == Kind::primitive) return why_postponed(item.id);
    if (item.kind != Kind::node) return {};
    const CellState state = marks_[item.id].state;
    if (state == CellState::unseen) return {"outside-view", "it lies outside the view"};
    if (state == CellState::hidden) {
        if (is_thin(item.id)) return {"no-pixel", "it covers no pixel of the small picture, and so was postponed"};
        Screen<D> screen;
        screen.show(small_problem_, shown_, shown_refreshed_);
        const SeenPart seen = screen.part_of(small_problem_, tree_->nodes[item.id].box);
        return {"covered", "it was covered, and so postponed: " + counted(seen.pixels, "pixel") +
                               " of it in the small picture, behind " +
                               some_of(D == 2 ? "segment" : "triangle", seen.hidden_by, most_hiders)};
    }
    if (state != CellState::clean) return {};
    const std::uint32_t above = opened_to(*tree_, marks_, item.id);
    const Item box{above, Kind::node};
    switch (marks_[above].state) {
        case CellState::unseen:
            return {"outside-view", "it lies in " + item_name(box) + ", which lies outside the view", box};
        case CellState::hidden:
            if (is_thin(above))
                return {"no-pixel",
                        "it lies in " + item_name(box) +
                            ", which covers no pixel of the small picture, and so was postponed",
                        box};
            return {"covered", "it lies in " + item_name(box) + ", which was covered, and so postponed", box};
        case CellState::projected:
            return {"drawn-whole", "it lies in " + item_name(box) + ", which was postponed and rendered as a whole",
                    box};
        default:
            return {"waits", "it lies in " + item_name(box) + ", which waits", box};
    }
}

template <int D>
bool FeedbackRun<D>::is_thin(std::uint32_t node) const {
    return std::find(thin_.begin(), thin_.end(), node) != thin_.end();
}

/// Of a primitive that is drawn into the picture and not rendered.
template <int D>
Verdict FeedbackRun<D>::why_postponed(std::uint32_t primitive) const {
    if (this->drawn_.has(primitive)) return {};
    const auto has = [&](const std::vector<std::uint32_t>& list) {
        return std::find(list.begin(), list.end(), primitive) != list.end();
    };
    const bool few = has(small_);
    if (!few && !has(lost_)) return {};
    std::string text =
        few ? "it waits, since it fills few pixels" : "it waits, since it won no pixel of the small picture";
    if (!is_late_) return {"waits", text + ", until no box is left"};
    const std::size_t place =
        static_cast<std::size_t>(std::find(late_.begin(), late_.end(), primitive) - late_.begin());
    return {"waits", text + ": number " + std::to_string(place + 1) + " of the " + std::to_string(late_.size()) +
                         " that were postponed one by one"};
}

template <int D>
std::optional<KeyExplanation> FeedbackRun<D>::key_terms(const Item& item, int digits) const {
    if (item.kind != Kind::node) return std::nullopt;
    return explain_box_key(squared_distance(tree_->nodes[item.id].box, this->problem_.view.eye),
                           pixels_ ? std::optional<double>((*largest_)[item.id]) : std::nullopt, digits);
}

template <int D>
std::vector<CodeLine> FeedbackRun<D>::code(const CodePlace& at) const {
    const Counters& counters = this->counters_;
    const bool in_step = at.in_step(), pops = at.step && at.step->item.kind == Kind::node;
    FeedbackRule rule = FeedbackRule::enqueued;
    for (const Change& change : at.changes)
        if (at.step && change.item() == at.step->item) rule = FeedbackRule{change.rule};
    const bool late = in_step && (!pops || rule == FeedbackRule::late);
    const std::string popped = pops ? item_name(at.step->item) : "";
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values = {}) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), {}});
    };
    const bool between = !in_step && counters.spent < this->problem_.budget;
    add("while a box waits:", 0, between && counters.front_size > 0,
        counters.front_size == 1 ? "1 box waits" : std::to_string(counters.front_size) + " boxes wait");
    add(pixels_ ? "take the one with the lowest distance² / √(largest size in it)" : "take the nearest one", 1, false);
    if (in_step && pops) lines.back().values = popped + ", " + key_terms(at.step->item, digits_of(*at.step))->sum();
    add("outside the view: drop it", 1, in_step && rule == FeedbackRule::outside, popped);
    add("it covers no pixel of the small picture: postpone it", 1, in_step && rule == FeedbackRule::too_thin, popped);
    add("its rectangle lies behind what the small picture shows: postpone it", 1,
        in_step && rule == FeedbackRule::covered, popped);
    add("it has halves: put them into the front", 1, in_step && rule == FeedbackRule::opened, popped);
    add("else draw it into the small picture, and render what wins a pixel", 1, in_step && rule == FeedbackRule::drawn,
        counted(at.rendered, "primitive") + " of " + popped);
    if (reduced_) add("or is too small to win one, where nothing covers it", 2, false);
    if (pixels_) add("but postpone what shows at few pixels", 2, false);
    lines.push_back(budget_line(*this, 1, "", false, in_step));
    lines.back().source.clear();
    add("then what was postponed: " + std::string(pixels_ ? "what shows at few pixels, " : "") +
            "boxes without a pixel, what won none, covered boxes",
        0, late || (between && counters.front_size == 0), counted(at.rendered, "primitive"));
    return lines;
}

#define SIGHTLINE_INSTANTIATE(D)                                                              \
    template std::string FeedbackRun<D>::popped_words(const Step&) const;                     \
    template Verdict FeedbackRun<D>::why_not(const Item&) const;                              \
    template bool FeedbackRun<D>::is_thin(std::uint32_t) const;                               \
    template Verdict FeedbackRun<D>::why_postponed(std::uint32_t) const;                      \
    template std::optional<KeyExplanation> FeedbackRun<D>::key_terms(const Item&, int) const; \
    template std::vector<CodeLine> FeedbackRun<D>::code(const CodePlace&) const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
