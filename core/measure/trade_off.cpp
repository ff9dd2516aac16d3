// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/trade_off.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/measure/frame_before.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

constexpr std::array usual_shares{0.01, 0.02, 0.05, 0.10};
/// Steps of one piece of a run: well under a millisecond where steps are small.
constexpr std::uint32_t steps_a_slice = 128;
/// Times taken of each frame, of traversal and of drawing, after one to warm up.
constexpr std::uint32_t repeats = 3;

}  // namespace

template <int D>
TradeOffStudy<D>::TradeOffStudy(TradeOffTask<D> task) : task_(std::move(task)), timed_(task_.variants.size()) {
    for (std::size_t v = 0; v < task_.variants.size(); ++v) add_usual_dots(v);
}

template <int D>
void TradeOffStudy<D>::add_usual_dots(std::size_t v) {
    if (!task_.variants[v].method.budgeted) return dots_.push_back({v, {}});
    if (task_.budget) return dots_.push_back({v, *task_.budget});
    for (const double share : usual_shares) dots_.push_back({v, {Budget::Kind::share, share}});
}

template <int D>
void TradeOffStudy<D>::ask(const Variant<D>& variant, const Budget& budget) {
    auto& all = task_.variants;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Variant<D>& other) { return other.text == variant.text; });
    const auto v = static_cast<std::size_t>(found - all.begin());
    if (found == all.end()) {
        all.push_back(variant);
        timed_.emplace_back();
        add_usual_dots(v);
    }
    const auto same = [&](const TradeOffDot& dot) { return dot.variant == v && dot.budget == budget; };
    if (std::any_of(dots_.begin(), dots_.end(), same)) return;
    std::erase_if(dots_, [](const TradeOffDot& dot) { return dot.asked; });
    if (variant.method.budgeted && budget.kind != Budget::Kind::milliseconds) dots_.push_back({v, budget, {}, true});
}

template <int D>
std::uint32_t TradeOffStudy<D>::primitives(const Budget& budget) const {
    const std::size_t all = task_.scene->primitives.size();
    return std::min(static_cast<std::uint32_t>(all), budget.primitives(all));
}

template <int D>
std::size_t TradeOffStudy<D>::done() const {
    std::size_t count = 0;
    for (const TradeOffDot& dot : dots_) count += dot.frames.size();
    return count;
}

template <int D>
std::size_t TradeOffStudy<D>::common_views() const {
    std::size_t count = task_.views.size();
    for (const TradeOffDot& dot : dots_)
        if (!dot.asked) count = std::min(count, dot.frames.size());
    return count;
}

template <int D>
double TradeOffStudy<D>::value(const TradeOffDot& dot, Measure measure) const {
    const std::size_t count = std::max<std::size_t>(common_views(), 1);
    if (dot.frames.size() < count) return std::numeric_limits<double>::quiet_NaN();
    return summary(std::span(dot.frames).first(count), measure);
}

/// Of the view and the method at work, if there is one, so that their run serves all budgets.
template <int D>
const TradeOffDot* TradeOffStudy<D>::next_dot() const {
    const TradeOffDot* next = nullptr;
    for (const TradeOffDot& dot : dots_) {
        if (dot.frames.size() == task_.views.size()) continue;
        if (work_ && dot.frames.size() == work_->view && dot.variant == work_->variant) return &dot;
        if (!next || dot.frames.size() < next->frames.size()) next = &dot;
    }
    return next;
}

template <int D>
bool TradeOffStudy<D>::advance() {
    const TradeOffDot* const next = next_dot();
    if (!next) return false;
    TradeOffDot* const dot = &dots_[static_cast<std::size_t>(next - dots_.data())];
    const std::size_t view = dot->frames.size();
    if (truth_view_ != view) {
        make_truth(view);
        return true;
    }
    const Variant<D>& variant = task_.variants[dot->variant];
    const std::uint32_t budget = variant.method.prefixes ? none : primitives(dot->budget);
    if (!work_ || work_->view != view || work_->variant != dot->variant || work_->run_budget != budget) {
        work_.emplace();
        work_->view = view;
        work_->variant = dot->variant;
        work_->run_budget = budget;
        work_->problem =
            make_problem(variant.method, variant.parameters, *task_.scene, *task_.cells, task_.views[view], budget,
                         known_services(std::make_shared<std::vector<std::uint8_t>>(truth_.reference.visible),
                                        task_.reference_size));
        if (!task_.before.empty())
            work_->problem.history = frame_history<D>(variant.method, work_->problem, task_.before[view]);
        work_->runner.emplace(variant.method, work_->problem);
    } else if (!work_->run) {
        if (work_->runner->advance(steps_a_slice)) return true;
        work_->run = work_->runner->finish(truth_.reference, false, task_.draw_ids);
        work_->runner.reset();
    } else if (work_->budget != dot->budget) {
        measure(*dot);
    } else {
        take_time(*dot);
    }
    return true;
}

template <int D>
void TradeOffStudy<D>::make_truth(std::size_t view) {
    work_.reset();  // its run is judged by the truth of its view
    truth_view_.reset();
    const CellComplex<D>* const cells = task_.cells.get();
    truth_ = std::move(
        make_truths<D>(*task_.scene, {&cells, 1}, task_.views[view], task_.reference_size, task_.draw_ids, false)
            .front());
    truth_view_ = view;
}

template <int D>
void TradeOffStudy<D>::measure(const TradeOffDot& dot) {
    const std::uint32_t budget = primitives(dot.budget);
    const auto rendered = rendered_by(*work_->run, cut_at(*work_->run, budget).met, task_.scene->primitives.size());
    const auto wrong = wrong_by(*work_->run, truth_.reference.image, rendered);
    work_->values = frame_numbers(*work_->run, truth_, budget, rendered, wrong, std::nullopt);
    work_->budget = dot.budget;
    work_->samples = 0;
    work_->times = {};
}

/// One sample: of the traversal, then of drawing what it left, each after one to warm up. The last one completes the
/// dot.
template <int D>
void TradeOffStudy<D>::take_time(TradeOffDot& dot) {
    Work& work = *work_;
    const bool drawn = D == 3 && task_.time_drawing;
    const std::uint32_t sample = work.samples++;
    if (sample <= repeats) {
        work.problem.budget = primitives(dot.budget);
        OwnRun<D>& run = timed_[dot.variant];
        // What a run keeps of the frame before must not be of this very view.
        if (task_.variants[dot.variant].method.needs.last_frame) run = {};
        const double ms = run_milliseconds(task_.variants[dot.variant].method, work.problem, run);
        // In 2D nothing is drawn: what a perfect order costs is all that there is to show.
        if (sample > 0 && (!drawn || pays_for_traversal(task_.variants[dot.variant].method)))
            work.times.traverse.push_back(ms);
        if (sample == repeats) {
            drawn_ids(*run, ids_);
            work.drawn = drawn_scene(*run, task_.scene);
        }
    } else if constexpr (D == 3) {
        const DrawTimes times = task_.time_drawing(work.drawn, task_.views[work.view], ids_);
        if (sample > repeats + 1) {
            work.times.upload.push_back(times.upload);
            work.times.draw.push_back(times.draw);
        }
    }
    if (work.samples < (drawn ? 2 : 1) * (repeats + 1)) return;
    set_times(work.times, work.values);
    dot.frames.push_back(work.values);
    work.budget.reset();
}

template class TradeOffStudy<2>;
template class TradeOffStudy<3>;

}  // namespace sightline
