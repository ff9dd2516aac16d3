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
        const auto& sides = shadows[shadow].sides;
        for (std::uint32_t side = 0; side < sides.size(); ++side, ++count)
            halves_.push_back({sides[side].edge, sides[side].polygon, shadow, side, sides[side].reversed});
    }
    group_.resize(count);
    std::sort(halves_.begin(), halves_.end(), [](const Half& a, const Half& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.polygon != b.polygon ? a.polygon < b.polygon : a.side < b.side;
    });
    for (std::uint32_t i = 0, first = 0; i < halves_.size(); ++i) {
        if (halves_[i].edge != halves_[first].edge) first = i;
        group_[begin_[halves_[i].shadow] + halves_[i].side] = first;
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
        const std::uint32_t shadow = meetings.partner(
            partial[i].shadow, side, [&](std::uint32_t other) { return other < place.size() && place[other] != none; });
        return shadow == none ? none : place[shadow];
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
