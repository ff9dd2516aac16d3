// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/claims.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"

namespace sightline::lab {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The row of a scene by the beginning of its name ("city" also finds "city:50k"); nullptr when there is none.
const Row* find(const Results& results, const std::string& scene, const std::string& method,
                const std::string& budget) {
    for (const Row& row : results.rows) {
        const bool same_scene = row.scene == scene || row.scene.starts_with(scene + ":");
        if (same_scene && method_text(row.method) == method && row.budget == budget) return &row;
    }
    return nullptr;
}

std::string with_per_cent(double share) { return short_number(100 * share) + " %"; }

/// A row's summary; NaN without a row.
double value(const Row* row, Measure m) { return row ? summary(*row, m) : unknown; }

}  // namespace

std::vector<Claim> judge_claims(const Results& results) {
    using enum Measure;
    std::vector<Claim> claims;
    // Adds the claim unless a value that it needs is missing.
    const auto add = [&](const char* source, const char* text, const Row* row, const std::string& ours, bool holds,
                         std::initializer_list<double> needed) {
        if (std::none_of(needed.begin(), needed.end(), [](double v) { return std::isnan(v); }))
            claims.push_back({source, text, ours, holds, row});
    };
    const auto scene = [](const Row* row) { return row ? row->scene : std::string(); };
    {
        const Row *published = find(results, "city", "published", "10%"),
                  *on_tree = find(results, "city", "published@tree", "10%"),
                  *centroid = find(results, "city", "centroid", "10%");
        const double delaunay = value(published, coverage), tree = value(on_tree, coverage),
                     sorted = value(centroid, coverage);
        add("TVCG 5.1", "At 10 % PLP on Delaunay cells finds over 90 % of what is visible in CITY.", published,
            scene(published) + ": " + with_per_cent(delaunay) + ".", delaunay > 0.9, {delaunay});
        add("TVCG 5.1",
            "At 10 % Delaunay cells find more than octree cells (64 %), and these more than sorting by distance "
            "(30 %) in CITY.",
            delaunay > tree ? on_tree : published,
            scene(published) + ": " + with_per_cent(delaunay) + ", " + with_per_cent(tree) + " and " +
                with_per_cent(sorted) + ".",
            delaunay > tree && tree > sorted, {delaunay, tree, sorted});
    }
    {
        const Row* published = find(results, "city", "published", "5%");
        const double found = value(published, coverage), ms = value(published, total_ms),
                     all = value(find(results, "city", "everything", "unlimited"), total_ms);
        add("TVCG 5.1, table 1",
            "At 5 % PLP finds 80 % of what is visible in CITY, at 4 times the speed of "
            "drawing everything.",
            found >= 0.8 ? nullptr : published,
            scene(published) + ": " + with_per_cent(found) + " at " + short_number(all / ms) + " times the speed.",
            found >= 0.8 && all / ms >= 4, {found, ms, all});
    }
    {
        const Row* published = find(results, "cars", "published", "1%");
        const double ms = value(published, total_ms),
                     all = value(find(results, "cars", "everything", "unlimited"), total_ms);
        add("TVCG 5.1", "At 1 % PLP is more than 10 times as fast as drawing everything in 5CBEM.", nullptr,
            scene(published) + ": " + short_number(all / ms) + " times.", all / ms > 10, {ms, all});
    }
    for (const char* name : {"city", "cars", "room"}) {
        const Row* plp = find(results, name, "published", "10%");
        const Row* sorted = find(results, name, "centroid", "10%");
        if (!plp || !sorted) continue;
        const double a = likeness(*plp), b = likeness(*sorted);
        add("TVCG 5.1, figs. 10 and 11",
            "Along a path PLP's count of visible primitives resembles the exact one, that of sorting by distance "
            "does not.",
            plp,
            plp->scene + ": r = " + short_number(a) + " and " + short_number(b) + " over " +
                std::to_string(plp->frames.size()) + " frames.",
            a > b, {a, b});
    }
    {
        const Row *on_tree = find(results, "room", "published@tree", "10%"),
                  *published = find(results, "room", "published", "10%");
        const double tree = value(on_tree, wrong), delaunay = value(published, wrong),
                     sorted = value(find(results, "room", "centroid", "10%"), wrong);
        add("TVCG 5.1, figs. 13 to 15", "In ROOM octree cells give the best image and sorting by distance the worst.",
            tree < delaunay ? published : on_tree,
            scene(on_tree) + ", wrong pixels at 10 %: octree " + with_per_cent(tree) + ", Delaunay " +
                with_per_cent(delaunay) + ", sorted " + with_per_cent(sorted) + ".",
            tree < delaunay && delaunay < sorted, {tree, delaunay, sorted});
    }
    return claims;
}

std::vector<Table1Row> table_1(const Results& results) {
    struct Printed {
        const char *scene, *papers_scene;
        std::array<double, 4> shares;
    };
    static constexpr std::array budgets{"1%", "2%", "5%", "10%"};
    static constexpr std::array<Printed, 2> printed{
        {{"city", "CITY", {0.51, 0.66, 0.80, 0.90}}, {"cars", "5CBEM", {0.44, 0.55, 0.67, 0.76}}}};
    std::vector<Table1Row> table;
    for (const Printed& p : printed)
        for (const char* method : {"published", "published@tree"}) {
            Table1Row row{p.scene, p.papers_scene, method, {budgets.begin(), budgets.end()}, {}, {}};
            bool any = false;
            for (std::size_t b = 0; b < budgets.size(); ++b) {
                const Row* found = find(results, p.scene, method, budgets[b]);
                row.ours.push_back(found ? summary(*found, Measure::coverage) : unknown);
                row.papers.push_back(std::string(method) == "published" ? p.shares[b] : unknown);
                any |= found != nullptr;
            }
            if (any) table.push_back(std::move(row));
        }
    return table;
}

}  // namespace sightline::lab
