// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/joint_test.h"

#include <algorithm>

namespace sightline {

template <int D>
void Meetings::find(std::span<const Shadow<D>> shadows) {
    begin_.clear();
    halves_.clear();
    std::uint32_t count = 0;
    for (std::uint32_t shadow = 0; shadow < shadows.size(); ++shadow) {
        begin_.push_back(count);
        for (std::uint32_t side = 0; side < shadows[shadow].sides.size(); ++side, ++count)
            halves_.push_back({shadows[shadow].sides[side].edge, shadow, side, shadows[shadow].sides[side].reversed});
    }
    partner_.assign(count, none);
    std::sort(halves_.begin(), halves_.end(), [](const Half& a, const Half& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.shadow != b.shadow ? a.shadow < b.shadow : a.side < b.side;
    });
    for (std::size_t i = 0, end; i < halves_.size(); i = end) {
        end = i;
        while (end < halves_.size() && halves_[end].edge == halves_[i].edge) ++end;
        for (std::size_t a = i; a < end; ++a) {
            if (partner(halves_[a].shadow, halves_[a].side) != none) continue;
            for (std::size_t b = a + 1; b < end; ++b) {
                if (halves_[b].reversed == halves_[a].reversed || halves_[b].shadow == halves_[a].shadow ||
                    partner(halves_[b].shadow, halves_[b].side) != none)
                    continue;
                partner_[begin_[halves_[a].shadow] + halves_[a].side] = halves_[b].shadow;
                partner_[begin_[halves_[b].shadow] + halves_[b].side] = halves_[a].shadow;
                break;
            }
        }
    }
}

template void Meetings::find<2>(std::span<const Shadow<2>>);
template void Meetings::find<3>(std::span<const Shadow<3>>);

std::vector<std::uint32_t> joint_set(std::span<const Partial> partial, const Meetings& meetings, Connected how,
                                     JointScratch& scratch) {
    auto& [place, group, todo] = scratch;
    for (std::uint32_t i = 0; i < partial.size(); ++i) {
        if (place.size() <= partial[i].shadow) place.resize(partial[i].shadow + 1, none);
        if (partial[i].beyond) place[partial[i].shadow] = i;
    }
    const auto partner_of = [&](std::uint32_t i, std::uint32_t side) {
        const std::uint32_t shadow = meetings.partner(partial[i].shadow, side);
        return shadow == none || shadow >= place.size() ? none : place[shadow];
    };
    const auto is_satisfied = [&](std::uint32_t i, std::uint32_t side) {
        return side < most_sides && (partial[i].satisfied >> side & 1);
    };
    group.assign(partial.size(), none);
    std::vector<std::uint32_t> found;
    for (std::uint32_t start = 0; start < partial.size() && found.empty(); ++start) {
        if (!partial[start].beyond || (how == Connected::on && group[start] != none)) continue;
        bool hides = true;
        todo.assign(1, start);
        group[start] = start;
        for (std::size_t next = 0; next < todo.size() && (hides || how == Connected::on); ++next)
            for (std::uint32_t side = 0; side < partial[todo[next]].sides; ++side) {
                const bool satisfied = is_satisfied(todo[next], side);
                if (satisfied && how == Connected::grow) continue;
                const std::uint32_t other = partner_of(todo[next], side);
                if (other == none) {
                    hides &= satisfied;
                } else if (group[other] != start) {
                    group[other] = start;
                    todo.push_back(other);
                }
            }
        if (hides) found = todo;
    }
    for (const Partial& p : partial) place[p.shadow] = none;
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace sightline
