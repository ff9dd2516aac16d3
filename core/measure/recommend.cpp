// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/recommend.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/measure/summary.h"

namespace sightline {

namespace {

constexpr double nearly_all = 0.9;
/// How far apart the times of one method are from one measurement to the next, as a share.
constexpr double noise = 0.1;

}  // namespace

std::optional<std::size_t> recommend(std::span<const Offer> offers, double most_wrong) {
    std::vector<Trade> trades;
    for (const Offer& offer : offers) trades.push_back({offer.ms, offer.wrong});
    std::optional<std::size_t> best;
    const auto good = [&](std::size_t i) { return offers[i].wrong <= most_wrong; };
    for (const std::size_t i : pareto_points(trades, Better::lower)) {  // by time, so with ever fewer wrong pixels
        const bool equal = best && offers[i].ms == offers[*best].ms && offers[i].wrong == offers[*best].wrong;
        if (!best || (!good(*best) && !equal) || (equal && offers[i].misses_nothing && !offers[*best].misses_nothing))
            best = i;
    }
    return best;
}

std::optional<std::size_t> close_second(std::span<const Offer> offers, std::size_t best, double most_wrong) {
    const Offer& taken = offers[best];
    std::optional<std::size_t> second;
    for (std::size_t i = 0; i < offers.size(); ++i) {
        const Offer& other = offers[i];
        const bool same = other.variant == taken.variant && other.tessellation == taken.tessellation;
        if (same || !(other.wrong <= std::max(most_wrong, taken.wrong))) continue;
        const double errors = 2 * std::sqrt(other.error * other.error + taken.error * taken.error);
        if (!(other.ms - taken.ms <= std::max(noise * taken.ms, errors))) continue;
        if (!second || other.ms < offers[*second].ms) second = i;
    }
    return second;
}

InView what_is_in_view(std::span<const double> drawn, std::span<const double> visible) {
    if (drawn.empty()) return InView::much_hidden;
    const auto is_none = [](double count) { return count == 0; };
    if (std::all_of(drawn.begin(), drawn.end(), is_none)) return InView::nothing;
    if (std::all_of(visible.begin(), visible.end(), is_none)) return InView::nothing_visible;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!(visible[i] >= nearly_all * drawn[i])) return InView::much_hidden;
    return InView::nearly_all_visible;
}

}  // namespace sightline
