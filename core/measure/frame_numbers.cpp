// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/frame_numbers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/measure/drawn_image.h"
#include "core/measure/rank_correlation.h"
#include "core/measure/wrong_region.h"
#include "core/methods/cells/cell_parameters.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

/// Coverage that k95 asks for.
constexpr double enough = 0.95;

double ratio(double part, double whole) { return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN(); }

}  // namespace

template <int D>
WholeRunner<D>::WholeRunner(const Method<D>& method, Problem<D> problem) {
    if (method.prefixes) problem.budget = none;
    whole_.whole = !method.prefixes;
    run_ = method.start(problem);
    recording_.start = run_->counters();
    largest_front_ = run_->counters().front_size;
    counts_cells_ = method.parameter(budget_counts_row().name) &&
                    problem.parameters.template choice<BudgetCounts>(budget_counts_row()) == BudgetCounts::per_cell;
    whole_.culled_costs = problem.parameters.template choice<CulledCost>(culled_cost_row()) == CulledCost::charged;
}

template <int D>
bool WholeRunner<D>::advance(std::uint32_t steps) {
    Recorder recorder(recording_);
    for (; steps > 0; --steps) {
        if (run_->run(1, &recorder) != Stop::steps) return false;
        largest_front_ = std::max(largest_front_, run_->counters().front_size);
        whole_.touched_after.push_back(run_->counters().touched_count);
        whole_.largest_front.push_back(largest_front_);
        whole_.tests_after.push_back(run_->tests());
        rounds_ += recording_.steps.back().item.kind == Kind::round;
        whole_.rounds_after.push_back(rounds_);
        if (counts_cells_) whole_.spent_after.push_back(run_->counters().spent);
        if (const Step& step = recording_.steps.back(); step.item.kind == Kind::cell) {
            zero_keys_ += step.key == 0;
            whole_.zero_keys_after.push_back(zero_keys_);
            whole_.popped_cells.push_back({run_->steps(), step.item.id, step.key});
        }
    }
    return true;
}

template <int D>
WholeRun WholeRunner<D>::finish(const Reference& reference, bool with_inversions, const DrawIds& draw_ids) {
    WholeRun whole = std::move(whole_);
    if (!run_->stand_ins().empty()) {
        for_stood_in(*run_, [&](std::uint32_t primitive) { whole.stood_in.push_back(primitive); });
        whole.drawn_levels = run_->counters().stood_in;
        whole.levels_wrong = wrong_mask(reference, *run_, draw_ids);
    }
    if (with_inversions) {
        whole.inversions = inversions(reference, *run_, recording_);
        std::sort(whole.inversions->begin(), whole.inversions->end(),
                  [](const Inversion& a, const Inversion& b) { return a.step < b.step; });
    }
    whole.met.assign(run_->met().begin(), run_->met().end());
    if (!whole.stood_in.empty()) return whole;  // no list of primitives tells when it was enough
    std::uint32_t rendered = 0;
    std::size_t found = 0;
    for (const Met entry : whole.met) {
        if (entry.culled()) continue;
        ++rendered;
        found += reference.visible[entry.primitive()];
        if (reference.visible[entry.primitive()] &&
            static_cast<double>(found) >= enough * static_cast<double>(reference.count)) {
            whole.k95 = rendered;
            break;
        }
    }
    return whole;
}

template <int D>
WholeRun whole_run(const Method<D>& method, Problem<D> problem, const Reference& reference, bool with_inversions,
                   const DrawIds& draw_ids) {
    WholeRunner<D> runner(method, std::move(problem));
    runner.advance(none);
    return runner.finish(reference, with_inversions, draw_ids);
}

Cut cut_at(const WholeRun& run, std::uint32_t budget) {
    if (run.whole) return {run.met.size(), run.touched_after.size()};
    if (!run.spent_after.empty()) {  // whole cells: the step that reaches the budget is the last
        if (budget == 0) return {};
        const auto reached = std::lower_bound(run.spent_after.begin(), run.spent_after.end(), budget);
        const auto steps = std::min<std::size_t>(static_cast<std::size_t>(reached - run.spent_after.begin()) + 1,
                                                 run.spent_after.size());
        return {run.touched_after[steps - 1], steps};
    }
    std::uint32_t spent = 0;
    std::size_t end = 0;
    for (; spent < budget && end < run.met.size(); ++end) spent += run.culled_costs || !run.met[end].culled();
    if (spent < budget) return {end, run.touched_after.size()};
    if (budget == 0) return {};
    const auto last = std::lower_bound(run.touched_after.begin(), run.touched_after.end(), end);
    return {end, static_cast<std::size_t>(last - run.touched_after.begin()) + 1};
}

std::uint32_t needed_budget(const WholeRun& run, const Reference& reference, double most_wrong, std::uint32_t most) {
    const auto does = [&](std::uint32_t budget) {
        return wrong_pixels(reference, std::span(run.met).first(cut_at(run, budget).met)) <= most_wrong;
    };
    if (!does(most)) return none;
    std::uint32_t low = 0, high = most;  // of what does not do, or is the first that may, and what does
    while (low < high) {
        const std::uint32_t middle = low + (high - low) / 2;
        if (does(middle))
            high = middle;
        else
            low = middle + 1;
    }
    return high;
}

std::vector<std::uint8_t> rendered_by(const WholeRun& run, std::size_t met, std::size_t primitive_count) {
    std::vector<std::uint8_t> mask = rendered_mask(std::span(run.met).first(met), primitive_count);
    for (const std::uint32_t primitive : run.stood_in) mask[primitive] = 1;
    return mask;
}

std::vector<std::uint8_t> wrong_by(const WholeRun& run, const IdImage& exact, std::span<const std::uint8_t> rendered) {
    return run.levels_wrong.empty() ? wrong_mask(exact, rendered) : run.levels_wrong;
}

KeysAndShares keys_and_shares(const WholeRun& run, const Reference& reference, std::size_t steps) {
    KeysAndShares found;
    if (reference.cell_share.empty()) return found;
    for (const PoppedCell& popped : run.popped_cells) {
        if (popped.step > steps) break;
        found.keys.push_back(popped.key);
        found.shares.push_back(reference.cell_share[popped.cell]);
    }
    return found;
}

Values frame_numbers(const WholeRun& run, const Truth& truth, std::uint32_t budget,
                     std::span<const std::uint8_t> rendered, std::span<const std::uint8_t> wrong,
                     std::optional<double> best_cells) {
    using M = Measure;
    const Reference& reference = truth.reference;
    std::size_t count = 0, found = 0, hit = 0, ranks = 0;
    for (std::size_t p = 0; p < rendered.size(); ++p) {
        if (!rendered[p]) continue;
        ++count;
        found += reference.visible[p];
        hit += (*truth.zeta)[p] > 0;
        ranks += (*truth.zeta)[p];
    }
    const auto of_pixels = [&](std::size_t part) {
        return ratio(static_cast<double>(part), static_cast<double>(wrong.size()));
    };
    const auto wrong_pixels = static_cast<std::size_t>(std::count(wrong.begin(), wrong.end(), 1));
    count = count - run.stood_in.size() + run.drawn_levels;
    double shown = 0, right = 0;
    for (std::size_t pixel = 0; pixel < wrong.size(); ++pixel) {
        if (reference.image.ids[pixel] == none) continue;
        ++shown;
        right += !wrong[pixel];
    }

    Values v;
    v[M::budget] = budget;
    v[M::rendered] = static_cast<double>(count);
    v[M::visible] = static_cast<double>(reference.count);
    v[M::coverage] = ratio(static_cast<double>(found), static_cast<double>(reference.count));
    v[M::coverage_px] = ratio(right, shown);
    if (const auto best = oracle(reference, budget)) v[M::oracle] = *best;
    if (best_cells) v[M::cell_oracle] = *best_cells;
    v[M::wrong] = of_pixels(wrong_pixels);
    v[M::blob] = of_pixels(largest_region(wrong, reference.image.width, reference.image.height));
    if (run.k95) v[M::k95] = static_cast<double>(*run.k95) / static_cast<double>(rendered.size());
    v[M::efficiency] = ratio(static_cast<double>(found), static_cast<double>(count));
    v[M::emitted_over_visible] = ratio(static_cast<double>(count), static_cast<double>(reference.count));
    v[M::zeta] = ratio(static_cast<double>(ranks), static_cast<double>(hit));

    v[M::fused] = truth.fused;

    const std::size_t steps = cut_at(run, budget).steps;
    v[M::steps] = static_cast<double>(steps);
    if (steps > 0 && run.zero_keys_after.size() >= steps)
        v[M::zero_keys] = ratio(run.zero_keys_after[steps - 1], static_cast<double>(steps));
    const KeysAndShares popped = keys_and_shares(run, truth.reference, steps);
    v[M::key_rank] = rank_correlation(popped.keys, popped.shares);
    v[M::front] = steps > 0 ? run.largest_front[steps - 1] : 0;
    v[M::tested] = steps > 0 && run.tests_after.size() >= steps ? static_cast<double>(run.tests_after[steps - 1]) : 0;
    if (steps > 0 && run.rounds_after.size() >= steps && run.rounds_after[steps - 1] > 0)
        v[M::rounds] = run.rounds_after[steps - 1];
    if (!run.inversions) return v;
    v[M::mis_ranked] = v[M::unreached] = 0;
    for (const Inversion& inversion : *run.inversions) {
        if (inversion.step > steps) break;
        ++v[inversion.kind == Inversion::Kind::mis_ranked ? M::mis_ranked : M::unreached];
    }
    return v;
}

template class WholeRunner<2>;
template class WholeRunner<3>;
template WholeRun whole_run<2>(const Method<2>&, Problem<2>, const Reference&, bool, const DrawIds&);
template WholeRun whole_run<3>(const Method<3>&, Problem<3>, const Reference&, bool, const DrawIds&);

}  // namespace sightline
