// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/truth/angular.h"
#include "core/truth/visible_set.h"

namespace sightline {

namespace {

/// A direction in which the order of the arcs under the ray changes. For a crossing, `arc` is not used.
struct Event {
    Direction at;
    enum Kind { stop, cross, start } kind;
    std::uint32_t arc = none;
};

struct Sweep {
    const Sector& sector;
    std::span<const Facing> facing;
    std::vector<Arc> arcs;

    int turn(const Direction& d, const Direction& e) const { return sightline::turn(sector.eye, facing, d, e); }

    /// Whether facing segment a is hit before b just after the given direction, which is in the range of both.
    bool before(std::uint32_t a, std::uint32_t b, const Direction& at) const {
        const std::uint32_t low = std::min(a, b), high = std::max(a, b);
        const Nearer order = nearer(facing[low], facing[high]);
        bool low_first = order == Nearer::first || order == Nearer::first_until_crossing;
        const bool crosses = order == Nearer::first_until_crossing || order == Nearer::second_until_crossing;
        if (crosses && turn(Direction{{}, low, high}, at) >= 0) low_first = !low_first;
        return low_first == (a == low);
    }
};

/// All events in counter-clockwise order.
std::vector<Event> events(const Sweep& sweep) {
    std::vector<Event> list;
    for (std::uint32_t i = 0; i < sweep.arcs.size(); ++i) {
        list.push_back({sweep.arcs[i].from, Event::start, i});
        list.push_back({sweep.arcs[i].to, Event::stop, i});
    }
    // The borders of a half plane lie on one line, where an orientation test cannot tell them apart.
    const auto part = [&](const Direction& d) {
        if (d.is_crossing()) return 1;
        return d.point == sweep.sector.right ? 0 : d.point == sweep.sector.left ? 2 : 1;
    };
    const auto before = [&](const Event& a, const Event& b) {
        if (const int part_a = part(a.at), part_b = part(b.at); part_a != part_b) return part_a < part_b;
        const int turn = sweep.turn(a.at, b.at);
        return turn != 0 ? turn > 0 : a.kind < b.kind;
    };
    const auto sort = [&] { std::stable_sort(list.begin(), list.end(), before); };
    sort();
    std::vector<std::uint32_t> active;
    const std::size_t ends = list.size();
    for (std::size_t i = 0; i < ends; ++i) {
        const std::uint32_t arc = list[i].arc;
        if (list[i].kind == Event::stop) {
            std::erase(active, arc);
            continue;
        }
        for (const std::uint32_t other : active) {
            const std::uint32_t low = std::min(sweep.arcs[arc].facing, sweep.arcs[other].facing);
            const std::uint32_t high = std::max(sweep.arcs[arc].facing, sweep.arcs[other].facing);
            const Nearer order = nearer(sweep.facing[low], sweep.facing[high]);
            if (order == Nearer::first || order == Nearer::second) continue;
            const Direction at{{}, low, high};
            if (sweep.turn(Direction{sweep.sector.right}, at) > 0 && sweep.turn(at, Direction{sweep.sector.left}) > 0)
                list.push_back({at, Event::cross});
        }
        active.push_back(arc);
    }
    sort();
    return list;
}

void rank_in_sector(const Sweep& sweep, std::vector<std::uint32_t>& layers) {
    const std::vector<Event> list = events(sweep);
    std::vector<std::uint32_t> active;  // facing segments, nearest first
    for (std::size_t i = 0; i < list.size();) {
        const Direction& at = list[i].at;
        std::vector<std::uint32_t> crossing;
        std::size_t starts = i;
        for (; starts < list.size() && list[starts].kind != Event::start; ++starts) {
            if (sweep.turn(at, list[starts].at) != 0) break;
            if (list[starts].kind == Event::stop)
                std::erase(active, sweep.arcs[list[starts].arc].facing);
            else
                crossing.insert(crossing.end(), {list[starts].at.first, list[starts].at.second});
        }
        if (!crossing.empty()) {
            // Those that cross, and what lies between them, are sorted anew; by insertion, as most stay in order.
            std::size_t low = active.size(), high = 0;
            for (const std::uint32_t facing : crossing) {
                const std::size_t place = std::find(active.begin(), active.end(), facing) - active.begin();
                low = std::min(low, place);
                high = std::max(high, place);
            }
            for (std::size_t k = low + 1; k <= high; ++k)
                for (std::size_t m = k; m > low && sweep.before(active[m], active[m - 1], at); --m)
                    std::swap(active[m], active[m - 1]);
        }
        for (i = starts; i < list.size() && list[i].kind == Event::start && sweep.turn(at, list[i].at) == 0; ++i) {
            const std::uint32_t facing = sweep.arcs[list[i].arc].facing;
            const auto place = std::partition_point(
                active.begin(), active.end(), [&](std::uint32_t other) { return sweep.before(other, facing, at); });
            active.insert(place, facing);
        }
        for (std::uint32_t k = 0; k < active.size(); ++k) {
            std::uint32_t& layer = layers[sweep.facing[active[k]].primitive];
            if (layer == 0 || k + 1 < layer) layer = k + 1;
        }
    }
}

}  // namespace

std::vector<std::uint32_t> layering_numbers(std::span<const Primitive<2>> primitives, const View<2>& view) {
    std::vector<std::uint32_t> layers(primitives.size(), 0);
    const FacingSet set = facing_set(primitives, view.eye);
    for (const Sector& sector : sectors(view))
        rank_in_sector({sector, set.facing, clipped_arcs(set.facing, sector)}, layers);
    return layers;
}

}  // namespace sightline
