// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/inversion.h"

#include <algorithm>

#include "core/measure/metrics.h"
#include "core/methods/cells/cell_rules.h"

namespace sightline {

Inversions::Inversions(std::span<const double> cell_share, std::span<const std::uint8_t> visible,
                       std::span<const Item> seeds)
    : share_(cell_share), visible_(visible), in_front_(LargerShare{share_}), clean_(LargerShare{share_}) {
    for (std::uint32_t cell = 0; cell < share_.size(); ++cell)
        if (share_[cell] > 0) clean_.insert(cell);
    // The seeds were in the front from the start; the first step pops one of them.
    for (const Item& seed : seeds)
        if (seed.kind == Kind::cell) reach(seed.id);
}

void Inversions::reach(std::uint32_t cell) {
    if (clean_.erase(cell) > 0) in_front_.insert(cell);
}

void Inversions::add_if_waiting(const Recording& recording, std::span<const Met> met, std::uint32_t step,
                                std::uint32_t cell) {
    if (in_front_.empty() && clean_.empty()) return;
    Inversion inversion{step, cell, Inversion::Kind::mis_ranked, none, 0};
    inversion.kind = in_front_.empty() ? Inversion::Kind::unreached : Inversion::Kind::mis_ranked;
    inversion.waiting = in_front_.empty() ? *clean_.begin() : *in_front_.begin();
    for_rendered(recording.met_in(step, met),
                 [&](std::uint32_t primitive) { inversion.wasted += !visible_[primitive]; });
    found_.push_back(inversion);
}

void Inversions::reach_enqueued(std::span<const Change> changes) {
    for (const Change& change : changes)
        if (change.kind == Kind::cell && Rule{change.rule} == Rule::enqueued) reach(change.id);
}

const Inversion* Inversions::at(std::uint32_t step) const {
    const auto found = std::lower_bound(found_.begin(), found_.end(), step,
                                        [](const Inversion& i, std::uint32_t s) { return i.step < s; });
    return found != found_.end() && found->step == step ? &*found : nullptr;
}

template <int D>
std::vector<Inversion> inversions(const Reference& reference, const Run<D>& run, const Recording& recording) {
    Inversions all(reference.cell_share, reference.visible, run.seeds());
    all.follow(recording, run.drawn().all(), [&](std::uint32_t cell) { return run.problem().cells->count(cell); });
    std::vector<Inversion> found = all.found();
    std::stable_sort(found.begin(), found.end(),
                     [](const Inversion& a, const Inversion& b) { return a.wasted > b.wasted; });
    return found;
}

template std::vector<Inversion> inversions<2>(const Reference&, const Run<2>&, const Recording&);
template std::vector<Inversion> inversions<3>(const Reference&, const Run<3>&, const Recording&);

}  // namespace sightline
