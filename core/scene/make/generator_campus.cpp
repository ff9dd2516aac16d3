// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <tuple>

#include "core/scene/make/campus_plan.h"
#include "core/scene/make/campus_things.h"
#include "core/scene/make/furniture.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/plots.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

void add_ground(NamedModel& made, NumberedNames& names) {
    constexpr double s = campus_half, k = kerb_edge, m = middle_street;
    const std::array<std::array<double, 4>, 7> roads = {{{-s, -m, s, m},
                                                         {-s, k, s, s},
                                                         {-s, -s, s, -k},
                                                         {-s, -k, -k, -m},
                                                         {-s, m, -k, k},
                                                         {k, -k, s, -m},
                                                         {k, m, s, k}}};
    for (const auto& [x0, y0, x1, y1] : roads) {
        const bool along_x = x1 - x0 > y1 - y0;
        const int pieces = along_x ? 8 : 4;
        for (int i = 0; i < pieces; ++i) {
            const double from = static_cast<double>(i) / pieces, to = static_cast<double>(i + 1) / pieces;
            const Vec<2> low = along_x ? Vec<2>(x0 + (x1 - x0) * from, y0) : Vec<2>(x0, y0 + (y1 - y0) * from);
            const Vec<2> high = along_x ? Vec<2>(x0 + (x1 - x0) * to, y1) : Vec<2>(x1, y0 + (y1 - y0) * to);
            made.add(names.next("road"), [&](Model& model) {
                model.box({low.x, low.y, -1}, {high.x, high.y, 0}, top_side);
            });
        }
    }
    for (const double side : {-1.0, 1.0}) {
        const double y0 = side < 0 ? -k : m, y1 = side < 0 ? -m : k;
        made.add(names.next("kerb"), [&](Model& model) {
            model.box({-k, y0, 0}, {k, y1, kerb_height}, left_side | right_side | front_side | back_side);
        });
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 8; ++i) {
                const Vec<2> low(-k + 15 * i, y0 + 14 * j), high(low + Vec<2>(15, 14));
                made.add(names.next("lawn"), [&](Model& model) {
                    model.box({low.x, low.y, 0}, {high.x, high.y, kerb_height}, top_side);
                });
            }
    }
}

/// Furniture of all rooms, storey by storey; the frame is that of the building.
void furnish_building(NamedModel& made, const BuildingPlan& plan, NumberedNames& names, std::uint64_t seed, int site) {
    for (int storey = 0; storey < plan.storeys; ++storey)
        for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
            if (made.model.full()) return;
            const Inside floor(made.model, {0, 0, campus_step + campus_storey * storey});
            furnish_planned(made, names, campus_stream(seed, 10 + site, 100 * storey + static_cast<int>(i)),
                            plan.rooms[i]);
        }
}

void add_outdoors(NamedModel& made, NumberedNames& names, std::uint64_t seed) {
    for (const OutdoorThing& thing : outdoor_things(seed)) {
        const bool on_road = thing.kind == OutdoorKind::car;
        const Inside frame(made.model, {thing.at.x, thing.at.y, on_road ? 0 : kerb_height}, thing.degrees);
        made.add(names.next(std::string(word(thing.kind))), [&](Model& m) {
            Random own = thing.own;
            switch (thing.kind) {
                case OutdoorKind::lamp:
                    return street_lamp(m);
                case OutdoorKind::bench:
                    return bench(m);
                case OutdoorKind::bollard:
                    return bollard(m);
                case OutdoorKind::car:
                    return simple_car(m);
                case OutdoorKind::oak:
                case OutdoorKind::fir:
                    return garden_tree(m, own);
                case OutdoorKind::hedge:
                    return m.box({-1.5, -0.4, 0}, {1.5, 0.4, 1.1}, all_sides & ~bottom_side);
            }
        });
    }
}

/// One campus about the origin, or as much of it as has `wanted` triangles: building after building, and when the next
/// one is too large, what stands outside.
NamedModel one_campus(std::uint64_t seed, std::size_t wanted) {
    NamedModel made;
    made.model.wanted = wanted;
    NumberedNames outside;
    add_ground(made, outside);
    for (std::size_t i = 0; i < campus_sites().size() && !made.model.full(); ++i) {
        const CampusSite& site = campus_sites()[i];
        const int number = static_cast<int>(i);
        Random random = campus_stream(seed, 1, number);
        const BuildingPlan plan = site_plan(site, random);
        NumberedNames names{"building " + std::to_string(i + 1) + " / "};
        const Inside frame(made.model, {site.corner.x, site.corner.y, kerb_height}, 90.0 * site.quarter_turns);
        NamedModel shell;
        shell.model.plan = made.model.plan;
        shell.model.height = made.model.height;
        campus_shell(shell, plan, names);
        if (made.model.triangles.size() + shell.model.triangles.size() > wanted) break;
        const auto first_object = static_cast<std::uint32_t>(made.objects.names.size());
        for (const std::uint32_t of : shell.objects.of) made.objects.of.push_back(first_object + of);
        const auto add_all = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        add_all(made.objects.names, shell.objects.names);
        add_all(made.model.triangles, shell.model.triangles);
        const auto first_room = static_cast<std::uint32_t>(made.rooms.all.size());
        for (Portal<3>& portal : shell.rooms.portals)
            for (std::uint32_t& room : portal.rooms)
                if (room != none) room += first_room;
        add_all(made.rooms.all, shell.rooms.all);
        add_all(made.rooms.portals, shell.rooms.portals);
        furnish_building(made, plan, names, seed, number);
    }
    add_outdoors(made, outside, seed);
    return made;
}

/// Squares of side 1 about the origin, so that the first k * k fill a square.
std::vector<Plot> plots_by_squares(std::size_t count) {
    int half = 1;
    while (static_cast<std::size_t>(2 * half + 1) * static_cast<std::size_t>(2 * half + 1) < count) ++half;
    std::vector<Plot> plots;
    for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x) plots.push_back({x, y});
    const auto rank = [](int c) { return c > 0 ? 2 * c - 1 : -2 * c; };
    const auto key = [&](const Plot& p) { return std::tuple(std::max(rank(p.x), rank(p.y)), p.y, p.x); };
    std::sort(plots.begin(), plots.end(), [&](const Plot& a, const Plot& b) { return key(a) < key(b); });
    plots.resize(count);
    return plots;
}

void add_copy(Generated& made, const NamedModel& campus, const Plot& plot, std::size_t number) {
    const Vec<3> offset(campus_side * plot.x, campus_side * plot.y, 0);
    const auto moved = [&](const Vec<3>& p) {
        return Vec<3>(float_value(p.x + offset.x), float_value(p.y + offset.y), p.z) + 0.0;
    };
    const std::string place = number == 0 ? "" : "campus " + std::to_string(number + 1) + " / ";
    for (const Primitive<3>& t : campus.model.triangles)
        made.triangles.push_back({moved(t[0]), moved(t[1]), moved(t[2])});
    const auto first_object = static_cast<std::uint32_t>(made.objects.names.size());
    const auto first_room = static_cast<std::uint32_t>(made.rooms.all.size());
    for (const std::string& name : campus.objects.names) made.objects.names.push_back(place + name);
    for (const std::uint32_t of : campus.objects.of) made.objects.of.push_back(first_object + of);
    for (const Room<3>& room : campus.rooms.all)
        made.rooms.all.push_back({place + room.name, {moved(room.shape.min), moved(room.shape.max)}});
    for (Portal<3> portal : campus.rooms.portals) {
        for (std::uint32_t& room : portal.rooms)
            if (room != none) room += first_room;
        for (Vec<3>& corner : portal.corners) corner = moved(corner);
        made.rooms.portals.push_back(std::move(portal));
    }
}

/// Out of the first room of the first building, along its corridor into the street and up over the roofs.
FlightPath<3> campus_walk(std::uint64_t seed) {
    const CampusSite& site = campus_sites()[0];
    Random random = campus_stream(seed, 1, 0);
    const BuildingPlan plan = site_plan(site, random);
    const double door = site.corner.x + plan.rooms[1].door, south = site.corner.y;
    const double corridor = south + plan.depth / 2, inside = 1.7 + kerb_height + campus_step, low = 1.7;
    const std::vector<Vec<3>> on_foot = {{door, south + 1.2, inside},
                                         {door, south + 5.1, inside},
                                         {door + 0.9, corridor, inside},
                                         {site.corner.x + site.length - 1, corridor, inside},
                                         {-11, corridor, low + kerb_height},
                                         {-8.5, corridor - 2, low + kerb_height},
                                         {-8.5, middle_street + 1, low + kerb_height},
                                         {-7, 0, low},
                                         {30, 0, low}};
    FlightPath<3> path = along("walk", on_foot, 168, 4, 60);
    const std::vector<Vec<3>> over = {{30, 0, low}, {36, 0, 3}, {46, -3, 14}, {54, -24, 40}, {56, -56, 70}};
    // Turning on the way up, from straight on past the north to the middle of the campus.
    const Vec<3> north(30, 45, 0), middle(-10, 20, 0);
    const std::vector<ViewSpec<3>> up = along("", over, 73, 6, 60).frames;
    for (std::size_t i = 1; i < up.size(); ++i) {
        const double turn = 2 * static_cast<double>(i) / static_cast<double>(up.size() - 1);
        const double part = turn < 1 ? turn : turn - 1, share = part * part * (3 - 2 * part);
        const Vec<3> ahead(up[i].look_at.x, up[i].look_at.y, low);
        const Vec<3> from = turn < 1 ? ahead : north, to = turn < 1 ? north : middle;
        path.frames.push_back({up[i].eye, from * (1 - share) + to * share, 60});
    }
    return path;
}

}  // namespace

Generated campus(std::uint64_t seed, std::size_t triangles) {
    const NamedModel whole = one_campus(seed, most_triangles);
    const std::size_t each = whole.model.triangles.size();
    const std::size_t nearest = (triangles + each / 2) / each;
    const std::size_t off = nearest * each > triangles ? nearest * each - triangles : triangles - nearest * each;
    const bool fits = nearest > 0 && 100 * off <= 3 * triangles;
    const std::size_t copies = fits ? nearest : triangles / each;
    Generated made;
    made.triangles.reserve(triangles + each);
    const std::vector<Plot> plots = plots_by_squares(copies + 1);
    for (std::size_t i = 0; i < copies; ++i) add_copy(made, whole, plots[i], i);
    if (!fits) add_copy(made, one_campus(seed, triangles - copies * each), plots[copies], copies);
    made.rooms.closed_from = campus_facade;
    made.paths.push_back(campus_walk(seed));
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace sightline::generate
