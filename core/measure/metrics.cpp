// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/metrics.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/traversal/traverse.h"

namespace sightline {

template <int D>
std::size_t visible_rendered(const Reference& reference, std::span<const std::uint32_t> touched) {
    std::size_t count = 0;
    for (const std::uint32_t entry : touched)
        if (!(entry & State<D>::culled_bit)) count += reference.visible[entry];
    return count;
}

double wrong_pixels(const Reference& reference, std::span<const std::uint32_t> touched) {
    if (reference.image.ids.empty()) return 0;
    auto wrong = static_cast<std::size_t>(std::count_if(reference.image.ids.begin(), reference.image.ids.end(),
                                                        [](std::uint32_t id) { return id != no_primitive; }));
    for (const std::uint32_t entry : touched)
        if (!(entry & State<3>::culled_bit)) wrong -= reference.pixels[entry];
    return static_cast<double>(wrong) / static_cast<double>(reference.image.ids.size());
}

std::optional<double> coverage(const Reference& reference, std::size_t visible_rendered) {
    if (reference.count == 0) return std::nullopt;
    return static_cast<double>(visible_rendered) / static_cast<double>(reference.count);
}

std::optional<double> oracle(const Reference& reference, std::size_t k) {
    if (reference.count == 0) return std::nullopt;
    return std::min(1.0, static_cast<double>(k) / static_cast<double>(reference.count));
}

template <int D>
std::optional<double> cell_oracle(const Reference& reference, const Frame<D>& frame) {
    if (reference.count == 0) return std::nullopt;
    std::vector<std::uint32_t> order(frame.cells->cell_count());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return reference.cell_share[a] > reference.cell_share[b];
    });
    State<D> state;
    begin_frame(state, frame);
    for (const std::uint32_t cell : order) {
        state.offset = 0;
        if (!detail::project(frame, state, cell)) break;
    }
    return coverage(reference, visible_rendered<D>(reference, state.touched));
}

template <int D>
std::vector<Inversion> inversions(const Reference& reference, const Frame<D>& frame, const State<D>& state,
                                  const Timeline& timeline) {
    std::vector<Inversion> found;
    const auto larger_share = [&](std::uint32_t a, std::uint32_t b) {
        const double sa = reference.cell_share[a], sb = reference.cell_share[b];
        return sa > sb || (sa == sb && a < b);
    };
    std::set<std::uint32_t, decltype(larger_share)> in_front(larger_share), clean(larger_share);
    for (std::uint32_t cell = 0; cell < frame.cells->cell_count(); ++cell)
        if (reference.cell_share[cell] > 0) clean.insert(cell);
    const auto reach = [&](std::uint32_t cell) {
        if (clean.erase(cell) > 0) in_front.insert(cell);
    };
    // The seeds were in the front from the start; the first step pops one of them.
    for (const std::uint32_t seed : seed_cells(frame)) reach(seed);
    for (std::uint32_t step = 1; step <= timeline.steps.size(); ++step) {
        const StepRecord& record = timeline.steps[step - 1];
        if (record.cell == none) continue;
        in_front.erase(record.cell);
        const bool hidden = reference.cell_share[record.cell] == 0 && frame.cells->count(record.cell) > 0;
        if (hidden && (!in_front.empty() || !clean.empty())) {
            Inversion inversion{step, record.cell, Inversion::Kind::mis_ranked, none, 0};
            inversion.kind = in_front.empty() ? Inversion::Kind::unreached : Inversion::Kind::mis_ranked;
            inversion.waiting = in_front.empty() ? *clean.begin() : *in_front.begin();
            const std::uint32_t first = timeline.touched_before(step);
            const auto fresh = std::span(state.touched).subspan(first, record.touched_count - first);
            inversion.wasted = static_cast<std::uint32_t>(record.rendered_count - timeline.rendered_before(step) -
                                                          visible_rendered<D>(reference, fresh));
            found.push_back(inversion);
        }
        const auto records = timeline.facets_of(step);
        const auto facets = frame.cells->facets_of(record.cell);
        for (std::size_t i = 0; i < records.size(); ++i)
            if (records[i].rule == Rule::enqueued) reach(facets[i].neighbour);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Inversion& a, const Inversion& b) { return a.wasted > b.wasted; });
    return found;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                \
    template std::size_t visible_rendered<D>(const Reference&, std::span<const std::uint32_t>); \
    template std::optional<double> cell_oracle<D>(const Reference&, const Frame<D>&);           \
    template std::vector<Inversion> inversions<D>(const Reference&, const Frame<D>&, const State<D>&, const Timeline&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
