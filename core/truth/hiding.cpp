// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/hiding.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/truth/angular.h"
#include "core/truth/reference.h"

namespace sightline {

namespace {

/// The arcs of a sector, and which of them a facing segment has.
struct SectorArcs {
    Sector sector;
    std::vector<Arc> arcs;
    std::vector<std::uint32_t> of;  ///< by facing segment: index into arcs, or none
};

/// Whether facing segment `a` hides `b` in all directions of the arc, which both have.
bool in_front(std::span<const Facing> facing, const Vec<2>& eye, std::uint32_t a, std::uint32_t b, const Arc& arc) {
    const std::uint32_t low = std::min(a, b), high = std::max(a, b);
    const bool a_is_first = a == low;
    switch (nearer(facing[low], facing[high])) {
        case Nearer::first:
            return a_is_first;
        case Nearer::second:
            return !a_is_first;
        // Where they cross outside the arc, one of them is nearer in all of it.
        case Nearer::first_until_crossing:
            return a_is_first ? turn(eye, facing, arc.to, {{}, low, high}) >= 0
                              : turn(eye, facing, {{}, low, high}, arc.from) >= 0;
        case Nearer::second_until_crossing:
            return a_is_first ? turn(eye, facing, {{}, low, high}, arc.from) >= 0
                              : turn(eye, facing, arc.to, {{}, low, high}) >= 0;
    }
    return false;
}

/// Whether `a` alone hides all that is in view of `b`.
bool hides(std::span<const Facing> facing, std::span<const SectorArcs> sectors, std::uint32_t a, std::uint32_t b) {
    for (const SectorArcs& s : sectors) {
        if (s.of[b] == none) continue;
        if (s.of[a] == none) return false;
        const Arc &front = s.arcs[s.of[a]], &back = s.arcs[s.of[b]];
        const Vec<2>& eye = s.sector.eye;
        if (turn(eye, facing, front.from, back.from) < 0 || turn(eye, facing, back.to, front.to) < 0) return false;
        if (!in_front(facing, eye, a, b, back)) return false;
    }
    return true;
}

}  // namespace

std::vector<Hiding> hiding(std::span<const Primitive<2>> primitives, const View<2>& view,
                           std::span<const std::uint32_t> zeta) {
    std::vector<Hiding> found(primitives.size(), Hiding::none);
    const FacingSet set = facing_set(primitives, view.eye);
    const auto count = static_cast<std::uint32_t>(set.facing.size());
    std::vector<SectorArcs> all;
    for (const Sector& sector : sectors(view)) {
        SectorArcs s{sector, clipped_arcs(set.facing, sector), std::vector<std::uint32_t>(count, none)};
        for (std::uint32_t i = 0; i < s.arcs.size(); ++i) s.of[s.arcs[i].facing] = i;
        all.push_back(std::move(s));
    }
    std::uint32_t last = 0;  // a large occluder hides many: it is tried first
    for (std::uint32_t b = 0; b < count; ++b) {
        const std::uint32_t primitive = set.facing[b].primitive;
        if (zeta[primitive] <= 1) continue;
        bool alone = last != b && hides(set.facing, all, last, b);
        for (std::uint32_t a = 0; a < count && !alone; ++a)
            if (a != b && hides(set.facing, all, a, b)) {
                alone = true;
                last = a;
            }
        found[primitive] = alone ? Hiding::alone : Hiding::fused;
    }
    return found;
}

std::vector<Hiding> hiding(std::span<const IdImage> layers, std::size_t primitive_count) {
    // Those in front of a primitive at every pixel seen so far.
    struct InFront {
        std::array<std::uint32_t, most_layers> ids;
        std::uint32_t count = none;  ///< none: no pixel yet
    };
    std::vector<Hiding> found(primitive_count, Hiding::none);
    std::vector<InFront> in_front(primitive_count);
    const std::size_t pixels = layers.empty() ? 0 : layers.front().ids.size();
    std::array<std::uint32_t, most_layers> ray{};
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (std::uint32_t depth = 0; depth < std::min<std::size_t>(layers.size(), most_layers); ++depth) {
            const std::uint32_t id = ray[depth] = layers[depth].ids[pixel];
            if (id == none) break;
            InFront& front = in_front[id];
            if (front.count == none) {
                std::copy_n(ray.begin(), depth, front.ids.begin());
                front.count = depth;
                continue;
            }
            const auto gone = [&](std::uint32_t other) {
                return std::find(ray.begin(), ray.begin() + depth, other) == ray.begin() + depth;
            };
            const auto begin = front.ids.begin();
            front.count = static_cast<std::uint32_t>(std::remove_if(begin, begin + front.count, gone) - begin);
        }
    }
    std::vector<std::uint8_t> visible(primitive_count);
    if (!layers.empty())
        for (const std::uint32_t id : layers.front().ids)
            if (id != none) visible[id] = 1;
    for (std::size_t p = 0; p < primitive_count; ++p)
        if (in_front[p].count != none && !visible[p]) found[p] = in_front[p].count > 0 ? Hiding::alone : Hiding::fused;
    return found;
}

double fused_share(std::span<const Hiding> all) {
    const auto alone = std::count(all.begin(), all.end(), Hiding::alone),
               fused = std::count(all.begin(), all.end(), Hiding::fused);
    return alone + fused > 0 ? static_cast<double>(fused) / static_cast<double>(alone + fused)
                             : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sightline
