// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/visible_set.h"

#include <utility>

#include "core/truth/angular.h"

namespace sightline {

namespace {

/// One owner, or nobody (none), from a direction to that of the next stretch or to the left border.
struct Stretch {
    Direction from;
    std::uint32_t owner;
};

/// Envelopes one behind the other: envelope i is stretches[begin[i]] to stretches[begin[i + 1]]. Each starts at the
/// right border of the sector, and no two neighbouring stretches have the same owner.
struct Envelopes {
    std::vector<Stretch> stretches;
    std::vector<std::size_t> begin{0};

    void clear() {
        stretches.clear();
        begin.assign(1, 0);
    }
    void append(const Direction& from, std::uint32_t owner) {
        if (stretches.size() > begin.back() && stretches.back().owner == owner) return;
        stretches.push_back({from, owner});
    }
    void close() { begin.push_back(stretches.size()); }
    std::size_t count() const { return begin.size() - 1; }
};

struct SectorSight {
    const Sector& sector;
    std::span<const Facing> facing;

    int turn(const Direction& d, const Direction& e) const { return sightline::turn(sector.eye, facing, d, e); }
};

/// Appends what is seen of segments a and b (or nobody) where both reach from `from` to `to`.
void append_nearer(const SectorSight& sight, Envelopes& out, const Direction& from, const Direction& to,
                   std::uint32_t a, std::uint32_t b) {
    if (a == none || b == none) return out.append(from, a == none ? b : a);
    if (a > b) std::swap(a, b);
    const Nearer order = nearer(sight.facing[a], sight.facing[b]);
    if (order == Nearer::first) return out.append(from, a);
    if (order == Nearer::second) return out.append(from, b);
    const std::uint32_t before = order == Nearer::first_until_crossing ? a : b, after = before == a ? b : a;
    const Direction crossing{{}, a, b};
    if (sight.turn(crossing, to) <= 0) return out.append(from, before);
    if (sight.turn(from, crossing) <= 0) return out.append(from, after);
    out.append(from, before);
    out.append(crossing, after);
}

/// Appends the envelope of two envelopes.
void merge(const SectorSight& sight, std::span<const Stretch> a, std::span<const Stretch> b, Envelopes& out) {
    const Direction end{sight.sector.left};
    Direction from = a[0].from;
    for (std::size_t i = 0, j = 0;;) {
        const bool last_a = i + 1 == a.size(), last_b = j + 1 == b.size();
        // The stretch that ends first; both when they end together.
        const int first = last_a && last_b ? 0 : last_a ? -1 : last_b ? 1 : sight.turn(a[i + 1].from, b[j + 1].from);
        const Direction& to = first > 0 ? a[i + 1].from : first < 0 ? b[j + 1].from : last_a ? end : a[i + 1].from;
        append_nearer(sight, out, from, to, a[i].owner, b[j].owner);
        if (last_a && last_b) break;
        from = to;
        if (first >= 0) ++i;
        if (first <= 0) ++j;
    }
    out.close();
}

/// The envelope of all arcs: who is the nearest in every direction of the sector.
std::vector<Stretch> envelope(const SectorSight& sight, std::span<const Arc> arcs) {
    Envelopes now, next;
    const Direction right{sight.sector.right};
    for (const Arc& arc : arcs) {
        if (arc.from.point != sight.sector.right) now.append(right, none);
        now.append(arc.from, arc.facing);
        if (arc.to.point != sight.sector.left) now.append(arc.to, none);
        now.close();
    }
    if (arcs.empty()) return {{right, none}};
    const auto at = [&](std::size_t i) {
        return std::span(now.stretches).subspan(now.begin[i], now.begin[i + 1] - now.begin[i]);
    };
    while (now.count() > 1) {
        next.clear();
        for (std::size_t i = 0; i + 1 < now.count(); i += 2) merge(sight, at(i), at(i + 1), next);
        if (now.count() % 2 == 1) {
            const std::span<const Stretch> odd = at(now.count() - 1);
            next.stretches.insert(next.stretches.end(), odd.begin(), odd.end());
            next.close();
        }
        std::swap(now, next);
    }
    return std::move(now.stretches);
}

}  // namespace

VisibleSet exact_visible_set(std::span<const Primitive<2>> primitives, const View<2>& view) {
    VisibleSet result;
    result.visible.assign(primitives.size(), 0);
    const FacingSet set = facing_set(primitives, view.eye);
    result.eye_on = set.eye_on;
    std::uint32_t last_owner = none;
    for (const Sector& sector : sectors(view)) {
        const std::vector<Stretch> seen = envelope({sector, set.facing}, clipped_arcs(set.facing, sector));
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::uint32_t owner = seen[i].owner;
            if (owner != none) {
                const Direction to = i + 1 < seen.size() ? seen[i + 1].from : Direction{sector.left};
                const Vec<2> end = point_on(set.facing, owner, view.eye, to);
                if (owner == last_owner)  // goes on over the border between two sectors
                    result.pieces.back().to = end;
                else
                    result.pieces.push_back(
                        {set.facing[owner].primitive, point_on(set.facing, owner, view.eye, seen[i].from), end});
            }
            last_owner = owner;
        }
    }
    for (const VisiblePiece& piece : result.pieces) result.visible[piece.primitive] = 1;
    for (const std::uint8_t visible : result.visible) result.count += visible;
    return result;
}

}  // namespace sightline
