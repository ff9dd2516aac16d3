// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/catalogue.h"
#include "core/scene/make/generators.h"
#include "core/scene/make/generators_failures.h"

namespace sightline {

namespace {

using Plan = std::vector<Primitive<2>> (*)(std::uint64_t seed);

/// Walls are as high as a room; the eye of a raised plan stands at half of that.
constexpr double wall_height = 3;

template <Plan plan>
Generated raised(std::uint64_t seed, std::size_t) {
    return failures::raise(plan(seed), wall_height);
}

/// A plan that both catalogues show.
struct PlanRow {
    CatalogueRow<2> plan;
    Generate<3> raised;
};

template <Plan plan>
PlanRow both(const char* id, std::uint64_t seed, const char* title, const char* lesson, const ViewSpec<2>& view,
             double error_bound, const char* budget, std::vector<SettingOverride> settings,
             std::vector<CatalogueBookmark> bookmarks) {
    return {{id,
             seed,
             title,
             lesson,
             plan,
             view,
             error_bound,
             "published",
             budget,
             std::move(settings),
             std::move(bookmarks),
             0,
             {}},
            raised<plan>};
}

constexpr CatalogueBookmark hidden{"visible_share == 0 && count > 0", "the first hidden cell that holds something"};
constexpr CatalogueBookmark half{"coverage >= 0.5", "half of what can be seen"};
constexpr CatalogueBookmark something{"rendered > 0", "the first primitive that is drawn"};

const std::vector<PlanRow>& plans() {
    using namespace failures;
    static const std::vector<PlanRow> rows{
        both<warehouse>(
            "warehouse", 6, "Warehouse from outside",
            "From outside, any cell at the border may hold something visible, but one seed starts at one spot, "
            "and the traversal goes in among the crates before it has covered the facade.",
            {{30, -70}, {30, 0}, 60}, 0.05, "5%", {}, {hidden, half}),
        both<niche>("niche", 20, "Wall that reaches the hull",
                    "The walls of a niche reach past the border of the cells: a traversal that starts in the niche "
                    "finds all its neighbours hidden and never comes to what stands in plain view beside it.",
                    {{20, -0.8}, {20, 20}, 168}, 0.05, "5%", {{"border", "none"}, {"jitter", "0"}}, {half}),
        both<fence>("fence", 7, "Fence at the border",
                    "The cells reach from leaf centre to leaf centre, so a fence at the border of the scene lies in no "
                    "cell and is never drawn, unless the corners of a larger box are added.",
                    {{20, 3}, {20, 40}, 100}, 0.05, "unlimited", {{"border", "none"}}, {something}),
        both<planks>("planks", 8, "Long planks",
                     "A plank from side to side of the scene lies in dozens of cells, and each of them keeps a "
                     "reference to it.",
                     {{20, 3}, {20, 40}, 80}, 0.05, "10%", {}, {half}),
        both<needles>("slats", 11, "Slats thinner than a pixel",
                      "An image shows some slats thinner than a pixel and misses others, so the visible set itself "
                      "flickers when the eye moves by less than a pixel.",
                      {{12, 0.5}, {12, 18}, 60}, 0.05, "20%", {}, {something}),
        both<lattice>("lattice", 12, "Lattice",
                      "On a lattice four leaf centres lie on one circle everywhere, so without jitter it is chance "
                      "which diagonal cuts a square.",
                      {{3.2, 1.3}, {20, 30}, 80}, 0.04, "10%", {{"jitter", "0"}}, {half}),
        both<graze>("graze", 16, "Along a wall",
                    "A wall in line with the eye subtends no angle: cosines and projected areas are 0 there, and what "
                    "divides by them is not a number.",
                    {{0, 0}, {60, 0}, 60}, 0.05, "10%", {}, {half}),
        both<cockpit>(
            "cockpit", 17, "Bars before the eye",
            "Bars a few millimetres from the eye fill much of the picture, lie in the cell that holds the eye, "
            "and are lost by any method that clips at a near plane.",
            {{20, 4}, {20, 40}, 90}, 0.05, "10%", {}, {something}),
        both<booth>("booth", 17, "Box round the eye",
                    "The eye stands in a booth hardly wider than itself: every cell round it has parts behind the eye, "
                    "and what is seen shows through a slit of 4 cm.",
                    {{20, 20}, {20, 40}, 90}, 0.05, "10%", {}, {something}),
        both<broken>(
            "broken", 18, "Broken primitives",
            "Files hold primitives with NaN or infinite coordinates, of zero size, or duplicated: they are left "
            "out and counted, and nothing else changes.",
            {{5, 5}, {30, 20}, 80}, 0.05, "10%", {}, {something}),
        both<posters>("posters", 19, "Posters in the wall",
                      "Where two primitives coincide, either may be called visible, so the visible set depends "
                      "on their order in the file.",
                      {{20, 2}, {20, 40}, 90}, 0.05, "20%", {}, {something}),
        both<thicket>("thicket", 20, "Thicket",
                      "A thick bush stands in an empty ring before a large far wall: a conservative method that tests "
                      "cells against one another's boxes may drop the wall for good.",
                      {{20, 3}, {20, 40}, 90}, 0.05, "30%", {}, {half}),
        both<corner>("corner", 24, "Street corner",
                     "A step sideways opens a whole street to the view: what appears then is not popping, "
                     "because the exact set changes as well.",
                     {{-14, 0}, {8, 30}, 80}, 0.05, "5%", {}, {half}),
        both<zigzag>("zigzag", 25, "Folded wall",
                     "A folded wall with buttresses is one piece but not convex: tests of single occluders hide only "
                     "what one fold hides alone.",
                     {{20, 3}, {20, 40}, 100}, 0.05, "10%", {}, {hidden}),
        both<ridge>("ridge", 26, "Edges that are silhouettes",
                    "Two walls share an edge, and behind it the view is free: a method that treats shared edges as "
                    "interior hides what stands beside them.",
                    {{20, 2}, {20, 40}, 100}, 0.05, "20%", {}, {half}),
        both<empty>("empty", 27, "Nothing at all",
                    "A scene without a single primitive is a scene: there is nothing to see, to draw or to miss, and "
                    "no coverage.",
                    {{0, 0}, {1, 0}, 60}, 0.05, "10%", {}, {}),
        both<single>("single", 27, "One primitive",
                     "One primitive makes a box that is flat, a single leaf and hardly a tessellation, and still it "
                     "has to be drawn.",
                     {{0, 0}, {0, 5}, 60}, 0.05, "100%", {}, {something}),
        both<onecell>("onecell", 27, "All in one cell",
                      "Nearly all primitives lie within a centimetre of a large scene: one cell holds them, and no "
                      "order of cells can tell them apart.",
                      {{24.005, 20.93}, {24.005, 21}, 30}, 0.05, "10%", {}, {something}),
        both<line>("line", 27, "All in line",
                   "All primitives lie on one line or in one plane, and what is built around them must not "
                   "degenerate: leaf centres lie on both sides, so there are cells.",
                   {{20, -15}, {20, 0}, 100}, 0.05, "50%", {}, {something}),
        both<fog>("fog", 28, "Fog of flakes",
                  "Few large flakes hang before a fine far wall: they own many pixels and little of the count, the "
                  "wall much of the count and few pixels.",
                  {{30, 2}, {30, 56}, 60}, 0.05, "10%", {}, {something}),
        both<gap>("gap", 30, "Gap of 8 cm",
                  "A sculpture shows through a gap in a wall that is smaller than a pixel of a coarse depth buffer.",
                  {{20, 4}, {20, 30}, 80}, 0.05, "20%", {}, {hidden, half}),
    };
    return rows;
}

/// A 2D scene of the lecture, raised.
CatalogueRow<3> raised_lesson(const char* id, const char* title, Generate<3> generate, double fov) {
    const CatalogueRow<2>& row = *find_in_catalogue<2>(id);
    const auto up = [](const Vec<2>& p) { return Vec<3>(p.x, p.y, wall_height / 2); };
    return {row.id,
            row.seed,
            title,
            row.lesson,
            generate,
            {up(row.view.eye), up(row.view.look_at), fov},
            row.error_bound,
            row.method,
            row.budget,
            row.settings,
            {half},
            0,
            {}};
}

}  // namespace

template <>
std::span<const CatalogueRow<2>> failure_scenes<2>() {
    static const std::vector<CatalogueRow<2>> rows = [] {
        std::vector<CatalogueRow<2>> made;
        for (const PlanRow& row : plans()) made.push_back(row.plan);
        made.push_back({"meadow",
                        21,
                        "Meadow all round",
                        "In a meadow nothing hides anything, so the front grows to a ring of hundreds of cells round "
                        "the eye: more than ids of 8 bits can tell apart.",
                        failures::meadow,
                        {{40.2, 40.1}, {60, 60}, 360},
                        0.015,
                        "published",
                        "30%",
                        {},
                        {half},
                        0,
                        {}});
        return made;
    }();
    return rows;
}

template <>
std::span<const CatalogueRow<3>> failure_scenes<3>() {
    static const std::vector<CatalogueRow<3>> rows = [] {
        std::vector<CatalogueRow<3>> made{
            raised_lesson("statue", "Statue", raised<statue>, 60),
            raised_lesson("forget", "Forgotten wall", raised<forget>, 50),
            raised_lesson("wallholes", "Wall with holes", raised<wallholes>, 70),
        };
        for (const auto& [plan, generate] : plans()) {
            const auto up = [](const Vec<2>& p) { return Vec<3>(p.x, p.y, wall_height / 2); };
            // Fields of view are horizontal in a plan and vertical in 3D.
            made.push_back({plan.id,
                            plan.seed,
                            plan.title,
                            plan.lesson,
                            generate,
                            {up(plan.view.eye), up(plan.view.look_at), 0.75 * plan.view.fov},
                            plan.error_bound,
                            plan.method,
                            plan.budget,
                            plan.settings,
                            plan.bookmarks,
                            0,
                            {}});
            CatalogueRow<3>& row = made.back();
            const std::string_view id = row.id;
            if (id == "slats") {
                row.generate = failures::needles_3d;
                row.title = "Needles and T-junctions";
                row.view = {{8, 0, 1.5}, {8, 10, 1.2}, 60};
            }
            if (id == "niche") row.view.fov = 160;  // as far to the sides as the plan's
            if (id == "lattice") {
                row.generate = failures::lattice_3d;
                row.error_bound = 0.07;
                row.view = {{3.2, 1.3, 2.1}, {10, 15, 9}, 60};
            }
        }
        made.push_back({"valley",
                        14,
                        "Valley from above",
                        "When nearly everything is visible no order can help: the best possible coverage is the budget "
                        "itself, and drawing the nearest first is as good as anything.",
                        failures::valley,
                        {{64, -20, 90}, {64, 64, 5}, 60},
                        0.05,
                        "published",
                        "30%",
                        {},
                        {something},
                        0,
                        {}});
        return made;
    }();
    return rows;
}

}  // namespace sightline
