// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/metrics.h"

#include <algorithm>
#include <numeric>

namespace sightline {

std::size_t visible_rendered(const Reference& reference, std::span<const Met> met) {
    std::size_t count = 0;
    for_rendered(met, [&](std::uint32_t primitive) { count += reference.visible[primitive]; });
    return count;
}

double wrong_pixels(const Reference& reference, std::span<const Met> met) {
    if (reference.image.ids.empty()) return 0;
    auto wrong = static_cast<std::size_t>(std::count_if(reference.image.ids.begin(), reference.image.ids.end(),
                                                        [](std::uint32_t id) { return id != none; }));
    for_rendered(met, [&](std::uint32_t primitive) { wrong -= reference.pixels[primitive]; });
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
std::optional<double> zero_key_share(const Run<D>& run) {
    std::uint32_t popped = 0, zeros = 0;
    for (std::uint32_t cell = 0; cell < run.problem().cells->cell_count(); ++cell) {
        const Mark mark = run.mark(cell);
        if (mark.state != CellState::projected) continue;
        ++popped;
        zeros += mark.key == 0;
    }
    if (popped == 0) return std::nullopt;
    return static_cast<double>(zeros) / static_cast<double>(popped);
}

template <int D>
std::optional<double> cell_oracle(const Reference& reference, const Problem<D>& problem) {
    if (reference.count == 0) return std::nullopt;
    std::vector<std::uint32_t> order(problem.cells->cell_count());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return reference.cell_share[a] > reference.cell_share[b];
    });
    const bool culled_costs = problem.parameters.template choice<CulledCost>(culled_cost_row()) == CulledCost::charged;
    Drawn drawn;
    drawn.begin(problem.primitives().size());
    Counters counters;
    const auto meet_all_of = [&](std::uint32_t cell) {
        for (const std::uint32_t primitive : problem.cells->primitives_of(cell))
            if (!meet(problem, culled_costs, primitive, true, drawn, counters)) return false;
        return true;
    };
    for (const std::uint32_t cell : order)
        if (!meet_all_of(cell)) break;
    return coverage(reference, visible_rendered(reference, drawn.all()));
}

template std::optional<double> zero_key_share<2>(const Run<2>&);
template std::optional<double> zero_key_share<3>(const Run<3>&);
template std::optional<double> cell_oracle<2>(const Reference&, const Problem<2>&);
template std::optional<double> cell_oracle<3>(const Reference&, const Problem<3>&);

}  // namespace sightline
