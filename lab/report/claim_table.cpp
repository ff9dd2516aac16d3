// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/claim_table.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "lab/report/gem_table.h"

namespace sightline::lab {

namespace {

using M = Measure;
using Found = std::optional<Regime>;

constexpr const char *plp = "published", *plp_on_tree = "published@tree", *by_distance = "centroid";
constexpr const char* draw_all = "everything";
/// ROOM from where its walls hide all that stands in it.
constexpr const char* outside = "outside";
/// What "about four times" has to reach.
constexpr double about_four = 3.5;
/// What "negligible" may add to a frame that is drawn with view culling.
constexpr double negligible = 0.1;
/// More pixels than these that come out right in one frame and wrong in its neighbour are "major" popping.
constexpr double major_flip = 0.01;
/// What a method may pop and flip more than layers, points.
constexpr double as_stable = 0.005;

double of(const Row* row, Measure m) { return row ? summary(*row, m) : std::numeric_limits<double>::quiet_NaN(); }
double worst_of(const Row* row, Measure m) { return row ? worst(*row, m) : std::numeric_limits<double>::quiet_NaN(); }

std::string percent(double share) { return short_number(100 * share) + " %"; }

/// Nothing where a value is missing.
Found found(std::string figures, bool holds, const Row* row, std::initializer_list<double> needed) {
    if (std::any_of(needed.begin(), needed.end(), [](double v) { return std::isnan(v); })) return std::nullopt;
    return Regime{{}, {}, std::move(figures), holds, row};
}

/// How many times as fast as view culling alone, and as drawing everything.
struct Speed {
    double times = 0, times_all = 0;
    std::string text() const {
        std::string text = short_number(times) + " times as fast as view culling";
        if (!std::isnan(times_all)) text += " (" + short_number(times_all) + " times as drawing everything)";
        return text;
    }
};
Speed speed(const Place& place, const char* method, const char* budget) {
    const double ms = of(place.row(method, budget), M::total_ms);
    return {of(place.row(view_culling, "unlimited"), M::total_ms) / ms,
            of(place.row(draw_all, "unlimited"), M::total_ms) / ms};
}

Found at_least(const Place& place, const char* method, const char* budget, double share) {
    const Row* row = place.row(method, budget);
    const double coverage = of(row, M::coverage);
    return found(percent(coverage), coverage >= share, row, {coverage});
}

Found as_fast(const Place& place, const char* method, const char* budget, double times) {
    const Speed s = speed(place, method, budget);
    return found(s.text(), s.times >= times, nullptr, {s.times});
}

Found worst_wrong(const Place& place, const char* method, double share) {
    const Row* row = place.row(method, "10%");
    const double wrong = worst_of(row, M::wrong);
    return found(percent(wrong), wrong <= share, row, {wrong});
}

Found order_by_count(const Place& place) {
    const Row *delaunay = place.row(plp, "10%"), *tree = place.row(plp_on_tree, "10%");
    const double a = of(delaunay, M::coverage), b = of(tree, M::coverage),
                 c = of(place.row(by_distance, "10%"), M::coverage);
    return found(percent(a) + ", " + percent(b) + " and " + percent(c), a > b && b > c, a > b ? tree : delaunay,
                 {a, b, c});
}

Found order_by_worst_pixels(const Place& place) {
    const Row *delaunay = place.row(plp, "10%"), *tree = place.row(plp_on_tree, "10%");
    const double a = worst_of(delaunay, M::wrong), b = worst_of(tree, M::wrong),
                 c = worst_of(place.row(by_distance, "10%"), M::wrong);
    return found(percent(a) + ", " + percent(b) + " and " + percent(c), a < b && b < c, a < b ? tree : delaunay,
                 {a, b, c});
}

Found resembles(const Place& place) {
    const Row *row = place.row(plp, "10%"), *other = place.row(by_distance, "10%");
    if (!row || !other) return std::nullopt;
    const double a = likeness(*row), b = likeness(*other);
    return found("r = " + short_number(a) + " and " + short_number(b), a > b, row, {a, b});
}

Found octree_is_faster(const Place& place) {
    const double tree = of(place.row(plp_on_tree, "10%"), M::total_ms),
                 delaunay = of(place.row(plp, "10%"), M::total_ms);
    return found(short_number(tree) + " and " + short_number(delaunay) + " ms", tree < delaunay, nullptr,
                 {tree, delaunay});
}

Found octree_layers_worse(const Place& place) {
    const Row *tree = place.row(plp_on_tree, "10%"), *delaunay = place.row(plp, "10%");
    const double a = of(tree, M::zeta), b = of(delaunay, M::zeta);
    return found("mean ζ " + short_number(a) + " and " + short_number(b) + ", coverage " +
                     percent(of(tree, M::coverage)) + " and " + percent(of(delaunay, M::coverage)),
                 a > b, a > b ? nullptr : delaunay, {a, b});
}

Found stable(const Place& place) {
    const Row* row = place.row(plp, "10%");
    const double pop = of(row, M::pop), change = of(row, M::visible_change), flip = of(row, M::flip);
    return found("popping " + percent(pop) + ", change of the exact set " + percent(change) + ", flipping pixels " +
                     percent(flip),
                 pop <= change && flip <= major_flip, row, {pop, change, flip});
}

/// Every method that may miss something against layers on the same cells; orders of primitives against those on
/// Delaunay cells.
Found as_stable_as_layers(const Place& place) {
    std::string worse;
    const Row *first = nullptr, *base = nullptr;
    std::size_t judged = 0;
    for (const Row* const row : place.here.rows) {
        if (row->budget != "10%" || !row->approximate || row->method.variant == "layers") continue;
        const Row* const layers = place.row(method_text({"layers", row->method.tessellation}), "10%");
        const double pop = of(row, M::pop) - of(layers, M::pop), flip = of(row, M::flip) - of(layers, M::flip);
        if (std::isnan(pop) || std::isnan(flip)) continue;
        base = layers;
        ++judged;
        if (pop <= as_stable && flip <= as_stable) continue;
        if (!first) first = row;
        worse += (worse.empty() ? "" : "; ") + method_text(row->method) + " pops " + percent(of(row, M::pop)) +
                 " and flips " + percent(of(row, M::flip)) + " (layers " + percent(of(layers, M::pop)) + " and " +
                 percent(of(layers, M::flip)) + ")";
    }
    if (judged == 0) return std::nullopt;
    if (worse.empty())
        worse = "all " + std::to_string(judged) + " methods; layers pop " + percent(of(base, M::pop)) + " and flip " +
                percent(of(base, M::flip));
    return found(std::move(worse), !first, first, {});
}

Found overhead(const Place& place) {
    const Row* culled = place.row(view_culling, "unlimited");
    const double traversal = of(place.row(plp, "10%"), M::traverse_ms), culling = of(culled, M::traverse_ms),
                 frame = of(culled, M::total_ms), more = (traversal - culling) / frame;
    return found("traversal " + short_number(traversal) + " ms, view culling " + short_number(culling) + " of " +
                     short_number(frame) + " ms",
                 more <= negligible, nullptr, {more});
}

/// The gem's budget, 140,000 of 13 million, or the nearest of the usual ones; its cells are the leaves of a tree.
const Row* gem_row(const Place& place, std::initializer_list<const char*> methods) {
    for (const char* const method : methods)
        for (const char* const budget : {"1.08%", "1%"})
            if (const Row* const row = place.row(method, budget)) return row;
    return nullptr;
}
const Row* gem_plp(const Place& place) { return gem_row(place, {"layers@tree", "layers"}); }
const Row* gem_cplp(const Place& place) {
    return gem_row(place, {"cplp@tree first=layers", "cplp first=layers", "cplp@tree", "cplp"});
}

Found right_as_in_the_gem(const Place& place) {
    const Row* row = gem_plp(place);
    if (!row) return std::nullopt;
    const Spread right = right_pixels(*row);
    return found(percent(right.mean) + ", three frames in four above " + percent(right.lower_quartile) + " (" +
                     method_text(row->method) + ", " + row->budget + ")",
                 right.mean >= 0.963 && right.lower_quartile >= 0.949, row, {right.mean});
}

Found as_many_frames_as_the_gem(const Place& place) {
    const Row *plp_row = gem_plp(place), *cplp = gem_cplp(place);
    if (!plp_row || !cplp) return std::nullopt;
    const Spread a = hz(*plp_row), b = hz(*cplp);
    return found(short_number(a.mean) + " Hz, three frames in four above " + short_number(a.lower_quartile) + ", and " +
                     short_number(b.mean) + " and " + short_number(b.lower_quartile) + " Hz (" +
                     method_text(cplp->method) + ", " + cplp->budget + ")",
                 a.mean >= 2 * b.mean && a.mean <= 10 * b.mean, nullptr, {a.mean, b.mean});
}

Found completes_the_picture(const Place& place) {
    const Row* row = gem_cplp(place);
    const double wrong = worst_of(row, M::wrong);
    return found(percent(wrong) + " wrong pixels in the worst frame, " + short_number(of(row, M::rounds)) +
                     " rounds and " + short_number(of(row, M::tested)) + " tests a frame",
                 wrong == 0, row, {wrong});
}

/// Coorg and Teller's own tables are `lab object-space`; these are said of frames as a person sees them.
constexpr const char *single = "coorg-teller", *connected = "coorg-teller connected=on",
                     *nothing_kept = "coorg-teller coherence=off";

Found connected_is_better(const Place& place) {
    const Row *one = place.row(single, "unlimited"), *several = place.row(connected, "unlimited");
    const double a = of(one, M::rendered), b = of(several, M::rendered), ms_a = of(one, M::traverse_ms),
                 ms_b = of(several, M::traverse_ms);
    return found("draws " + short_number(b) + " and " + short_number(a) + ", traversal " + short_number(ms_b) +
                     " and " + short_number(ms_a) + " ms",
                 b < a && ms_b < ms_a, nullptr, {a, b, ms_a, ms_b});
}

Found coherence_saves(const Place& place) {
    const double kept = of(place.row(single, "unlimited"), M::traverse_ms),
                 anew = of(place.row(nothing_kept, "unlimited"), M::traverse_ms);
    return found("traversal " + short_number(kept) + " ms, with nothing kept " + short_number(anew) + " ms",
                 kept < anew, nullptr, {kept, anew});
}

/// What it finds of what is in view and hidden, and what finds more there.
Found small_polygons_hide_little(const Place& place) {
    const Row *row = place.row(single, "unlimited"), *view = place.row(view_culling, "unlimited");
    const double all = of(view, M::rendered), hidden = all - of(view, M::visible), ms = of(row, M::total_ms);
    const auto culled = [&](const Row* of_method) { return (all - of(of_method, M::rendered)) / hidden; };
    std::string text = "culls " + percent(culled(row)) + " of what is in view and hidden";
    if (const Row* const boxes = place.row("boxes", "unlimited"))
        text += " (boxes held against a depth image " + percent(culled(boxes)) + ")";
    if (!std::isnan(ms))
        text += ", " + short_number(ms) + " ms a frame, view culling " + short_number(of(view, M::total_ms));
    return found(std::move(text), culled(row) < 0.5, nullptr, {culled(row)});
}

bool inside(const Place& place) { return place.here.path != outside; }

Found best_image_on_octree(const Place& place) {
    if (!inside(place)) return std::nullopt;
    const Row *on_tree = place.row(plp_on_tree, "10%"), *delaunay = place.row(plp, "10%");
    const double a = of(on_tree, M::wrong), b = of(delaunay, M::wrong), c = of(place.row(by_distance, "10%"), M::wrong);
    return found("wrong pixels " + percent(a) + ", " + percent(b) + " and " + percent(c), a < b && b < c,
                 a < b ? delaunay : on_tree, {a, b, c});
}

Found count_is_not_pixels(const Place& place) {
    if (!inside(place)) return std::nullopt;
    const Row *sorted = place.row(by_distance, "10%"), *tree = place.row(plp_on_tree, "10%"),
              *delaunay = place.row(plp, "10%");
    const double count = of(sorted, M::coverage), pixels = of(sorted, M::wrong),
                 most = std::max(of(tree, M::coverage), of(delaunay, M::coverage)),
                 more = std::max(of(tree, M::wrong), of(delaunay, M::wrong));
    return found("coverage " + percent(count) + " against " + percent(most) + ", wrong pixels " + percent(pixels) +
                     " against " + percent(more),
                 count >= 0.9 * most && pixels > more, sorted, {count, most, pixels, more});
}

/// The share of what view culling draws that is hidden.
double hidden_in_view(const Place& place) {
    const Row* culled = place.row(view_culling, "unlimited");
    return 1 - of(culled, M::visible) / of(culled, M::rendered);
}

Found walls_hide_from_outside(const Place& place) {
    if (!inside(place)) return std::nullopt;
    const auto at = std::find_if(place.all.begin(), place.all.end(), [&](const Group& other) {
        return other.scene == place.here.scene && other.path == outside;
    });
    if (at == place.all.end()) return std::nullopt;
    const Place from_outside{*at, place.all};
    const Row* row = place.row(plp, "10%");
    const double hidden = hidden_in_view(from_outside), hidden_here = hidden_in_view(place),
                 coverage = of(from_outside.row(plp, "10%"), M::coverage), coverage_here = of(row, M::coverage);
    return found("of what is in view " + percent(hidden) + " is hidden from outside, " + percent(hidden_here) +
                     " from inside; at 10 % PLP finds " + percent(coverage) + " and " + percent(coverage_here),
                 hidden > hidden_here && coverage > coverage_here, row, {hidden, hidden_here, coverage, coverage_here});
}

}  // namespace

const Row* Place::row(const std::string& method, const std::string& budget) const {
    for (const Row* row : here.rows)
        if (row->budget == budget && method_text(row->method) == method) return row;
    return nullptr;
}

std::span<const ClaimRow> claim_table() {
    using enum Frames;
    static const std::vector<std::string> city{"CITY"}, cars{"5CBEM"}, both{"CITY", "5CBEM"}, room{"ROOM"},
        all{"CITY", "5CBEM", "ROOM"}, plant{"PLANT"}, small{"CITY", "5CBEM", "PLANT"},
        models{"SODA", "CITY OF BOXES", "TETRA"};
    static const std::vector<ClaimRow> table{
        {"TVCG 5.2.1", "At 10 % PLP on Delaunay cells finds over 90 % of what is visible in CITY.", "", city,
         whole_path, [](const Place& p) { return at_least(p, plp, "10%", 0.9); }},
        {"TVCG 5.2.1",
         "At 10 % Delaunay cells find more than octree cells (64 %), and these more than sorting by distance (30 %) in "
         "CITY.",
         "", city, whole_path, order_by_count},
        {"TVCG 5.2.3, table 1", "At 5 % PLP finds 80 % of what is visible in CITY.", "", city, whole_path,
         [](const Place& p) { return at_least(p, plp, "5%", 0.8); }},
        {"TVCG table 1", "At 1 % PLP finds over 40 % of what is visible in CITY and in 5CBEM.", "", both, whole_path,
         [](const Place& p) { return at_least(p, plp, "1%", 0.4); }},
        {"TVCG 5.2.3", "At 5 % PLP is 4 times as fast as the whole of CITY.", "against view culling", city, whole_path,
         [](const Place& p) { return as_fast(p, plp, "5%", 4); }},
        {"TVCG 5.2.3", "At 1 % PLP is more than 10 times as fast as the whole of 5CBEM.", "against view culling", cars,
         whole_path, [](const Place& p) { return as_fast(p, plp, "1%", 10); }},
        {"TVCG 5.2.1, fig. 12c", "At 10 % PLP on Delaunay cells is over 2 times as fast as the whole of CITY.",
         "against view culling", city, whole_path, [](const Place& p) { return as_fast(p, plp, "10%", 2); }},
        {"TVCG 5.2.1, fig. 12c", "At 10 % PLP on octree cells is about 4 times as fast as the whole of CITY.",
         "against view culling, at least 3.5 times", city, whole_path,
         [](const Place& p) { return as_fast(p, plp_on_tree, "10%", about_four); }},
        {"TVCG 7", "PLP is faster on octree cells than on Delaunay cells.", "at 10 %", all, whole_path,
         octree_is_faster},
        {"TVCG 7", "Octree cells do not keep to the layers of the primitives as well as Delaunay cells do.",
         "at 10 %, mean layering number of what is rendered", all, whole_path, octree_layers_worse},
        {"TVCG 1", "PLP adds negligible overhead to view culling.",
         "at 10 %, the traversal takes longer than view culling by at most a tenth of a view-culled frame", all,
         whole_path, overhead},
        {"TVCG 5.2, 5.2.1", "At 10 % PLP on Delaunay cells gets at most 4 % of the pixels of CITY wrong in any frame.",
         "", city, whole_path, [](const Place& p) { return worst_wrong(p, plp, 0.04); }},
        {"TVCG 5.2.1", "At 10 % PLP on octree cells gets at most 9 % of the pixels of CITY wrong in any frame.", "",
         city, whole_path, [](const Place& p) { return worst_wrong(p, plp_on_tree, 0.09); }},
        {"TVCG 5.2.1, fig. 12b",
         "At 10 % the worst frame has fewest wrong pixels on Delaunay cells (4 %), more on octree cells (9 %) and most "
         "when sorted by distance (40 %) in CITY.",
         "", city, whole_path, order_by_worst_pixels},
        {"TVCG 5.2", "At 10 % PLP gets at most 12 % of the pixels of 5CBEM wrong in any frame.", "", cars, whole_path,
         [](const Place& p) { return worst_wrong(p, plp, 0.12); }},
        {"TVCG 5.2.3, figs. 10a and 11a",
         "Along a path PLP's count of visible primitives resembles the exact one, that of sorting by distance does "
         "not.",
         "at 10 %, the larger r", both, whole_path, resembles},
        {"TVCG 7", "The visible set that PLP estimates is stable: no major popping between nearby viewpoints.",
         "at 10 %, neighbouring frames: popping below the change of the exact set, and at most 1 % of the pixels flip",
         both, neighbours, stable},
        {"TVCG 7, asked of every method", "What other methods draw is stable between nearby viewpoints too.",
         "at 10 %, neighbouring frames: popping and flipping pixels at most .5 points above those of layers on the "
         "same "
         "cells",
         small, neighbours, as_stable_as_layers},
        {"TVCG 5.2.2, figs. 13 and 14",
         "In ROOM octree cells give the best image, Delaunay cells the second best and sorting by distance the worst.",
         "wrong pixels at 10 %", room, whole_path, best_image_on_octree},
        {"TVCG 5.2.2, fig. 15",
         "In ROOM sorting by distance does well by the count of visible primitives, and yet gets most pixels wrong.",
         "at 10 %, nine tenths of the best count of PLP, and more wrong pixels than either", room, whole_path,
         count_is_not_pixels},
        {"TVCG 5.2.2", "The walls of ROOM make culling easy from outside; from inside they hide nothing in it.",
         "more of what is in view is hidden from outside, and PLP finds more at 10 %", room, whole_path,
         walls_hide_from_outside},
        {"gem, results",
         "With 1.08 % of the primitives PLP gets 96.3 % of the pixels right, and more than 94.9 % in three frames of "
         "four.",
         "by layers, at 1 or 1.08 %", plant, whole_path, right_as_in_the_gem},
        {"gem, results",
         "With 1.08 % of the primitives PLP draws 10.1 frames a second and cPLP 2.1, and three frames in four are "
         "faster than 9.3 and 1.5.",
         "by layers; on another machine the ratio counts, here 2 to 10", plant, whole_path, as_many_frames_as_the_gem},
        {"gem, cPLP", "cPLP misses nothing that is visible.", "no wrong pixel in any frame", plant, whole_path,
         completes_the_picture},
        {"CT 5", "Scenes of many small polygons are not handled well.",
         "it culls less than half of what is in view and hidden", small, whole_path, small_polygons_hide_little},
        {"CT 4.2", "Connected occluders cull more than single ones, and take less time.",
         "fewer primitives drawn and a shorter traversal, in a view", models, whole_path, connected_is_better},
        {"CT 3.1, 4.3", "What is kept from frame to frame saves time.",
         "a shorter traversal than with coherence=off, in a view", models, whole_path, coherence_saves}};
    return table;
}

}  // namespace sightline::lab
