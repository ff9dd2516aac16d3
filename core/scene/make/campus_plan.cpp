// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/campus_plan.h"

#include <array>
#include <cmath>

#include "core/scene/make/plots.h"

namespace sightline {

namespace {

constexpr std::array<CampusSite, 8> sites = {{
    {{-46, 11}, 0, 32, 0, 6, 2},
    {{-2, 11}, 0, 24, 0, 5, 2},
    {{30, 11}, 0, 24, 16, 0, 1, PlannedUse::hall},
    {{-46, 38}, 0, 18, 0, 3, 1},
    {{8, 38}, 0, 11, 0, 2, 4},
    {{-28, -40}, 1, 17, 0, 3, 1},
    {{-10, -24}, 0, 20, 0, 4, 1},
    {{34, -22}, 0, 8, 6, 0, 1, PlannedUse::kiosk},
}};

/// Where no tree may stand: buildings with what is before their doors, and the way of the walk.
bool is_free(const Vec<2>& p) {
    for (const CampusSite& site : sites) {
        const double deep = site.depth > 0 ? site.depth : 12.25;
        const Vec<2> low = site.quarter_turns == 0 ? site.corner : site.corner - Vec<2>(deep, 0);
        const Vec<2> high = low + (site.quarter_turns == 0 ? Vec<2>(site.length, deep) : Vec<2>(deep, site.length));
        if (p.x > low.x - 3.5 && p.x < high.x + 3.5 && p.y > low.y - 3.5 && p.y < high.y + 3.5) return false;
    }
    return !(p.x > -15 && p.x < -4 && p.y > 0 && p.y < 26);
}

}  // namespace

std::span<const CampusSite> campus_sites() { return sites; }

BuildingPlan site_plan(const CampusSite& site, Random& random) {
    return site.depth > 0 ? hall_plan(site.length, site.depth, site.use)
                          : offices_plan(random, site.length, site.rooms_in_row, site.storeys);
}

Random campus_stream(std::uint64_t seed, int what, int which) { return Plot{what, which}.random(seed); }

std::vector<OutdoorThing> outdoor_things(std::uint64_t seed) {
    using enum OutdoorKind;
    Random random = campus_stream(seed, 2, 0);
    std::vector<OutdoorThing> all;
    const auto place = [&](OutdoorKind kind, const Vec<2>& at, double degrees) {
        all.push_back({kind, at, degrees, Random(0)});
    };
    for (double x = -58; x < 60; x += 14)
        for (const double side : {-1.0, 1.0}) {
            const double y = side * (middle_street + 0.5), turn = side < 0 ? 180 : 0;
            place(lamp, {x, y}, turn);
            if (is_free({x + 4, y + side})) place(bench, {x + 4, y + side}, turn);
            for (const double aside : {2.0, 7.0, 9.5})
                if (is_free({x + aside, y})) place(bollard, {x + aside, y}, 0);
        }
    for (double x = -52; x < 56; x += 6.5)
        for (const double side : {-1.0, 1.0}) {
            const bool parked = random.below(10) < 7;
            const double y = side * (middle_street - 1.1), edge = side * 61.5;
            if (parked && (x < -18 || x > -2)) place(car, {x, y}, side < 0 ? 0 : 180);
            if (random.below(2) == 0) place(car, {x, edge}, side < 0 ? 180 : 0);
        }
    for (int j = 0; j < 14; ++j)
        for (int i = 0; i < 14; ++i) {
            const double x = -54 + 8.3 * i + random.uniform(-1.5, 1.5);
            const double y = -54 + 8.3 * j + random.uniform(-1.5, 1.5);
            const std::uint64_t kind = random.below(8);
            const Random own(random.bits());
            if (std::abs(y) < middle_street + 2 || !is_free({x, y})) continue;
            all.push_back({kind < 3 ? oak : kind < 6 ? fir : hedge, {x, y}, 0, own});
        }
    return all;
}

}  // namespace sightline
