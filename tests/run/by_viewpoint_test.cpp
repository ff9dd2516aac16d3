// Choice by viewpoint: look-ups are total, choices are the cheapest, and a table changes nothing but the time it takes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/by_viewpoint.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/methods/by_viewpoint/table_file.h"
#include "core/methods/by_viewpoint/viewpoint_run.h"
#include "core/methods/method_table.h"
#include "core/run/timeline.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/scene/scene_view.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/visible_set.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

template <int D>
Vec<D> random_vector(Random& random) {
    Vec<D> v;
    for (int a = 0; a < D; ++a) v[a] = random.uniform(-1, 1);
    return v;
}

template <int D>
void directions_are_total(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const auto azimuths = static_cast<std::uint32_t>(3 + random.below(14));
        const auto elevations = static_cast<std::uint32_t>(1 + random.below(6));
        const Directions<D> directions(azimuths, elevations, static_cast<int>(random.below(D)));
        for (std::uint32_t at = 0; at < directions.count(); ++at) {
            const double across = random.uniform(1e-6, 1 - 1e-6), up = random.uniform(1e-6, 1 - 1e-6);
            const Vec<D> inside = directions.inside(at, across, up);
            ASSERT_EQ(directions.at(inside * random.uniform(0.001, 1000)), at) << directions.words(at);
        }
        const Vec<D> any = random_vector<D>(random);
        ASSERT_LT(directions.at(any), directions.count());
    }
}
TEST(Directions, EveryDirectionLiesInTheIntervalItIsIn2d) { directions_are_total<2>(1); }
TEST(Directions, EveryDirectionLiesInTheIntervalItIsIn3d) { directions_are_total<3>(2); }

TEST(Directions, HaveNoSeamAndNoPole) {
    const Directions<3> directions(8, 3, 2);
    EXPECT_EQ(directions.count(), 26u);
    // Just to either side of ±180°.
    EXPECT_EQ(directions.at({-1, 1e-12, 0}), directions.at({-1, -1e-12, 0}));
    EXPECT_EQ(directions.at({1, 1e-12, 0}), directions.at({1, -1e-12, 0}));
    // Whatever the azimuth, straight up is one interval, and straight down another.
    for (double x : {-1e-9, 0.0, 1e-9})
        for (double y : {-1e-9, 0.0, 1e-9}) {
            EXPECT_EQ(directions.at({x, y, 1}), 25u);
            EXPECT_EQ(directions.at({x, y, -1}), 24u);
        }
    EXPECT_EQ(directions.words(25), "elevation 67.5° to 90°");
    EXPECT_EQ(directions.words(8), "azimuth −22.5° to 22.5°, elevation −22.5° to 22.5°");
}

template <int D>
Scene<D> some_scene(Random& random, std::size_t count) {
    if constexpr (D == 2)
        return test::random_scene(random, count);
    else
        return test::random_scene_3d(random, count);
}

template <int D>
void regions_are_total(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        Scene<D> scene = some_scene<D>(random, 1 + random.below(50));
        Room<D> room{"hall", {}};
        if constexpr (D == 2)
            room.shape = {{.25, .25}, {.5, .25}, {.5, .5}};
        else
            room.shape = {{.25, .25, .25}, {.5, .5, .5}};
        scene.rooms.all.push_back(room);
        const Regions<D> regions(scene, static_cast<std::uint32_t>(1 + random.below(6)));
        for (int k = 0; k < 100; ++k) {
            const Vec<D> eye = random_vector<D>(random) * (random.below(4) == 0 ? 1e6 : 1.0);
            const std::uint32_t region = regions.at(eye);
            ASSERT_LT(region, regions.count());
            ASSERT_EQ(regions.is_room(region), holds(room, eye));
            if (regions.is_room(region)) continue;
            // No other box is nearer.
            const auto distance = [&](std::uint32_t box) {
                const Vec<D> nearest = glm::clamp(eye, regions.box(box).min, regions.box(box).max);
                return glm::dot(nearest - eye, nearest - eye);
            };
            for (std::uint32_t other = 0; other < regions.boxes(); ++other)
                ASSERT_LE(distance(region), distance(other) * (1 + 1e-9) + 1e-24);
        }
    }
}
TEST(Regions, EveryEyeBelongsToTheNearestBoxOrItsRoom2d) { regions_are_total<2>(3); }
TEST(Regions, EveryEyeBelongsToTheNearestBoxOrItsRoom3d) { regions_are_total<3>(4); }

EntryFacts facts_with(std::vector<std::array<float, 2>> costs, bool interior = false, float few = 0, float all = 0) {
    EntryFacts facts;
    for (const auto& [cull, draw] : costs) facts.costs.push_back({cull, draw, 0});
    facts.interior = interior;
    facts.few_cover = few;
    facts.all_cover = all;
    facts.candidates = {1, 2};
    return facts;
}

TEST(Choice, IsTheCheapest) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        std::vector<std::array<float, 2>> costs(1 + random.below(6));
        for (auto& [cull, draw] : costs) {
            cull = static_cast<float>(random.below(5));
            draw = static_cast<float>(random.below(5));
        }
        const Entry entry = choose(facts_with(costs), {}, {});
        for (std::uint32_t k = 0; k < costs.size(); ++k) {
            const float mine = costs[entry.chosen][0] + costs[entry.chosen][1], other = costs[k][0] + costs[k][1];
            ASSERT_LE(mine, other);
            ASSERT_TRUE(mine < other || k >= entry.chosen) << "of equal ones the first";
        }
    }
}

TEST(Choice, FollowsThePapersRule) {
    ChoiceSettings settings;
    settings.rule = ChoiceRule::paper;
    settings.frame_ms = 10;
    settings.few_cover = 0.5;
    const RuleTechniques by_rule{1, 2, 3};  // view; portals; shadow-frusta; hom
    const auto chosen = [&](const EntryFacts& facts) {
        const Entry entry = choose(facts, settings, by_rule);
        return std::pair(entry.chosen, entry.reason);
    };
    using std::pair;
    EXPECT_EQ(chosen(facts_with({{0, 9}, {0, 1}, {0, 1}, {0, 1}}, true, 1, 1)), pair(0u, ChoiceReason::fits));
    EXPECT_EQ(chosen(facts_with({{0, 20}, {0, 5}, {0, 1}, {0, 1}}, true, 1, 1)), pair(1u, ChoiceReason::interior));
    EXPECT_EQ(chosen(facts_with({{0, 20}, {0, 1}, {0, 5}, {0, 1}}, false, .6f, 1)), pair(2u, ChoiceReason::few_large));
    EXPECT_EQ(chosen(facts_with({{0, 20}, {0, 1}, {0, 1}, {0, 5}}, false, .4f, .6f)),
              pair(3u, ChoiceReason::many_small));
    EXPECT_EQ(chosen(facts_with({{0, 20}, {0, 1}, {0, 1}, {0, 1}}, false, .1f, .4f)), pair(0u, ChoiceReason::open));
    EXPECT_EQ(chosen(facts_with({{0, 20}, {0, 1}, {15, 5}, {0, 1}}, false, .6f, 1)), pair(0u, ChoiceReason::no_gain));
    const std::vector<std::string> titles{"view", "portals", "shadow frusta", "occlusion maps"};
    const Entry entry = choose(facts_with({{0, 20}, {0, 1}, {1, 4}, {0, 1}}, false, .62f, 1), settings, by_rule);
    const std::vector<Decision> said = decisions(entry, settings, titles);
    ASSERT_EQ(said.size(), 3u);
    EXPECT_EQ(said[0].sentence, "what is in view takes 20 ms > 10 ms");
    EXPECT_EQ(said[2].sentence, "shadow frusta: 5 ms = culling 1 + drawing 4 (0 primitives): done");
    EXPECT_EQ(entry.facts.candidates.size(), 2u) << "kept for a technique that uses them";
    EXPECT_TRUE(choose(facts_with({{0, 1}}), settings, by_rule).facts.candidates.empty());
}

TEST(Choice, ChangesOnlyWhereItPays) {
    ChoiceSettings settings;
    settings.switch_ms = 8;
    settings.valid_frames = 4;
    const Entry entry = choose(facts_with({{0, 10}, {0, 7}, {0, 9}}), settings, {});
    EXPECT_EQ(entry.chosen, 1u);
    EXPECT_TRUE(pays_to_switch(entry, none, settings));
    EXPECT_TRUE(pays_to_switch(entry, 0, settings));   // 8 / 4 + 7 < 10
    EXPECT_FALSE(pays_to_switch(entry, 2, settings));  // 8 / 4 + 7 = 9
    EXPECT_FALSE(pays_to_switch(entry, 1, settings));
}

template <int D>
struct ViewpointCase {
    Scene<D> scene;
    CellComplex<D> cells;
    Parameters parameters;
    const Method<D>& method = find_method<D>(method_table<D>(), by_viewpoint_id);

    explicit ViewpointCase(Random& random, const std::string& settings) {
        scene = some_scene<D>(random, 100 + random.below(200));
        cells = build_cells(scene, TessellationSettings{.error_bound = 0.3});
        for (const auto& [name, value] : read_variant("by-viewpoint " + settings).assignments)
            parameters.set(*method.parameter(name), value);
    }
    Problem<D> problem(const View<D>& view, std::shared_ptr<const FrameHistory> history = nullptr) const {
        Services services;
        services.image = D == 2 ? ImageSize{512, 1} : ImageSize{64, 48};
        return make_problem(method, parameters, scene, cells, view, none, services, std::move(history));
    }
    View<D> view(Random& random) const {
        ViewSpec<D> spec;
        spec.eye = (random_vector<D>(random) + Vec<D>(1)) / 2.0;
        spec.look_at = spec.eye + random_vector<D>(random);
        return scene_view(spec, scene, {64, 48});
    }
    std::shared_ptr<const ViewpointTable<D>> table(const Problem<D>& problem) const {
        return viewpoint_table<D>(method_table<D>(), problem);
    }
};

/// Three that cull, at prices that make each the cheapest somewhere.
constexpr const char* three =
    "techniques='view; boxes; shadow-frusta' cost=max-of-sums grid=2 azimuths=4 elevations=1 samples=2 "
    "vertex_ns=200 pixel_ns=0 cull_times='view 100/0; boxes 400/100; shadow-frusta 900/10'";

template <int D>
void cheapest_of_all(std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<std::size_t> chosen(3);
    for (int i = 0; i < count; ++i) {
        const ViewpointCase<D> made(random, three);
        const View<D> view = made.view(random);
        const Problem<D> problem = made.problem(view);
        const auto table = made.table(problem);
        const std::size_t place = table->place(view);
        const Entry& entry = table->at(place);
        ++chosen[entry.chosen];
        // By hand: each technique in each view, and the model's line for it.
        std::vector<double> cost(3);
        Analyst<D> analyst(table->problem());
        for (const ViewSpec<D>& spec : analyst.views(table->region_of(place), table->interval_of(place))) {
            ASSERT_EQ(table->place(spec.eye, spec.look_at - spec.eye), place);
            const View<D> from = scene_view(spec, made.scene, problem.services.image);
            for (std::uint32_t k = 0; k < 3; ++k) {
                const Variant<D>& option = table->problem().options[k];
                const auto run = option.method.start(make_problem<D>(option.method, option.parameters, made.scene,
                                                                     made.cells, from, none, problem.services));
                run->run(none);
                const double drawn = run->counters().rendered_count;
                constexpr std::array<std::array<double, 2>, 3> times{{{100, 0}, {400, 100}, {900, 10}}};
                // So many vertices that pixels never decide.
                cost[k] += times[k][0] * run->steps() + times[k][1] * run->counters().touched_count + 200 * D * drawn;
            }
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(entry.facts.costs[k].ms(), cost[k] / 2e6, 1e-5 * cost[k] / 2e6);
            ASSERT_LE(cost[entry.chosen], cost[k] * (1 + 1e-5));
        }
    }
    EXPECT_GT(chosen[0], 0u);
    EXPECT_GT(chosen[1] + chosen[2], 0u);
}
TEST(ByViewpoint, ChoosesWhatTheModelFindsCheapest2d) { cheapest_of_all<2>(6, test::soak_count(30)); }
TEST(ByViewpoint, ChoosesWhatTheModelFindsCheapest3d) { cheapest_of_all<3>(7, test::soak_count(15)); }

template <int D>
void table_is_a_cache(std::uint64_t seed) {
    Random random(seed);
    const ViewpointCase<D> made(random, three);
    const Problem<D> problem = made.problem(made.view(random));
    const ViewpointTable<D> one(made.table(problem)->problem()), side_by_side(one.problem()), asked(one.problem());
    // Stopped in the middle, and continued.
    std::size_t seen = 0;
    one.fill(1, [&](std::size_t known) { return (seen = known) < one.size() / 2; });
    EXPECT_EQ(one.known(), one.size() / 2);
    one.fill(1, {});
    EXPECT_EQ(one.known(), one.size());
    side_by_side.fill(4, {});
    for (std::size_t place = one.size(); place-- > 0;) {
        EXPECT_EQ(asked.at(place), *one.find(place));
        EXPECT_EQ(*side_by_side.find(place), *one.find(place));
    }
    const MergedSize merged = merged_size(one);
    EXPECT_EQ(merged.entries, one.size());
    EXPECT_LT(merged.merged_entries, merged.entries);

    const auto path = std::filesystem::path(testing::TempDir()) / ("viewpoints_" + std::to_string(D) + ".json");
    write_table(one, path);
    const ViewpointTable<D> read(one.problem());
    read_table(read, path);
    EXPECT_EQ(read.known(), one.size());
    for (std::size_t place = 0; place < one.size(); ++place) EXPECT_EQ(*read.find(place), *one.find(place));

    // Another scene, and damaged files: a clear line, and no entry that cannot be.
    ViewpointProblem<D> of_other = one.problem();
    Scene<D> other = made.scene;
    other.primitives.pop_back();
    of_other.scene = &other;
    EXPECT_THROW(read_table(ViewpointTable<D>(of_other), path), InputError);
    const std::string text = read_file(path, 1 << 26);
    for (int i = 0; i < test::soak_count(200); ++i) {
        std::string damaged = text;
        if (random.below(4) == 0)
            damaged.resize(random.below(damaged.size()));
        else
            for (int k = 0; k < 3; ++k)
                damaged[random.below(damaged.size())] = "0123456789-,[]{}\"ex."[random.below(20)];
        write_file(path, damaged);
        const ViewpointTable<D> table(one.problem());
        try {
            read_table(table, path);
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("viewpoints_"), std::string::npos);
        }
        for (std::size_t place = 0; place < table.size(); ++place)
            if (const Entry* entry = table.find(place)) {
                ASSERT_LT(entry->chosen, 3u);
                ASSERT_EQ(entry->facts.costs.size(), 3u);
            }
    }
    std::filesystem::remove(path);
}
TEST(ByViewpoint, ATableSavesTimeAndNothingElse2d) { table_is_a_cache<2>(8); }
TEST(ByViewpoint, ATableSavesTimeAndNothingElse3d) { table_is_a_cache<3>(9); }

template <int D>
void does_as_the_technique(std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const ViewpointCase<D> made(random, three);
        OwnRun<D> along;  // goes on from view to view
        for (int frame = 0; frame < 4; ++frame) {
            const Problem<D> problem = made.problem(made.view(random));
            along.start(problem, made.method.start);
            along->run(none);
            const auto& run = dynamic_cast<const ViewpointRun<D>&>(*along);
            const Variant<D>& option = run.table().problem().options[run.technique()];
            const auto alone = option.method.start(make_problem<D>(option.method, option.parameters, made.scene,
                                                                   made.cells, problem.view, none, problem.services));
            alone->run(none);
            ASSERT_EQ(run.steps(), alone->steps() + 1);
            ASSERT_EQ(run.counters(), alone->counters());
            ASSERT_TRUE(std::equal(run.met().begin(), run.met().end(), alone->met().begin(), alone->met().end()));
            ASSERT_EQ(run.misses(), alone->misses());

            Timeline<D> timeline;
            OwnRun<D> stepped = made.method.start(problem);
            const std::uint64_t at_start = stepped->hash();
            timeline.begin(*stepped);
            while (timeline.forward(stepped) == Stop::none) {
            }
            ASSERT_EQ(stepped->hash(), run.hash());
            ASSERT_EQ(timeline.steps.front().item.kind, Kind::region);
            while (timeline.back(stepped)) {
            }
            ASSERT_EQ(stepped->hash(), at_start);
        }
    }
}
TEST(ByViewpoint, DoesAsItsTechniqueDoes2d) { does_as_the_technique<2>(10, test::soak_count(10)); }
TEST(ByViewpoint, DoesAsItsTechniqueDoes3d) { does_as_the_technique<3>(11, test::soak_count(6)); }

/// Rooms are regions as well, which techniques pop: a step of theirs is no look-up.
TEST(ByViewpoint, GoesBackAndForthThroughRooms) {
    const Scene<2> scene = make_scene(*find_in_catalogue<2>("rooms"));
    const CellComplex<2> cells;
    for (const char* const technique : {"portals", "pvs"}) {
        const Variant<2> variant =
            make_variant<2>(method_table<2>(), std::string("by-viewpoint samples=1 techniques=") + technique);
        OwnRun<2> run = variant.method.start(
            make_problem(variant.method, variant.parameters, scene, cells, make_view(*scene.start_view)));
        Timeline<2> timeline;
        timeline.begin(*run);
        std::vector<std::uint64_t> hashes{run->hash()};
        while (timeline.forward(run) == Stop::none) {
            hashes.push_back(run->hash());
            ASSERT_LT(hashes.size(), 1000u);
        }
        ASSERT_GT(hashes.size(), 5u);
        for (std::size_t step = hashes.size(); step-- > 0;) {
            EXPECT_EQ(run->hash(), hashes[step]) << technique << " " << step;
            EXPECT_EQ(run->steps(), step);
            EXPECT_EQ(timeline.back(run), step > 0);
        }
        timeline.seek(run, 3);
        EXPECT_EQ(run->hash(), hashes[3]);
        while (timeline.forward(run) == Stop::none) {
        }
        EXPECT_EQ(run->hash(), hashes.back());
    }
}

/// An eye anywhere in an entry's region, looking anywhere into its interval: not only the views that the entry was
/// worked out in.
template <int D>
View<D> view_of_an_entry(const ViewpointTable<D>& table, const Scene<D>& scene, Random& random) {
    const std::size_t place = random.below(static_cast<std::uint32_t>(table.size()));
    const Box<D> box = table.regions().box(table.region_of(place));
    ViewSpec<D> spec;
    for (int a = 0; a < D; ++a) spec.eye[a] = random.uniform(box.min[a], box.max[a]);
    spec.look_at = spec.eye + table.directions().inside(table.interval_of(place), random.unit(), random.unit());
    return scene_view(spec, scene, {64, 48});
}

TEST(ByViewpoint, NothingVisibleIsLostAnywhereInTheVolumesOfEntries2d) {
    Random random(12);
    std::size_t visible = 0, drawn_in_all = 0, views = 0;
    const auto look = [&](const Scene<2>& scene, const CellComplex<2>& cells, const std::string& settings, int count) {
        const Variant<2> variant = make_variant<2>(method_table<2>(), "by-viewpoint " + settings);
        Services services;
        services.image = {512, 1};
        const auto problem = [&](const View<2>& view) {
            return make_problem(variant.method, variant.parameters, scene, cells, view, none, services);
        };
        const auto table = viewpoint_table<2>(method_table<2>(), problem(make_view(ViewSpec<2>{{0, 0}, {1, 0}, 60})));
        for (int i = 0; i < count; ++i, ++views) {
            const View<2> view = view_of_an_entry(*table, scene, random);
            const auto run = variant.method.start(problem(view));
            run->run(none);
            ASSERT_EQ(run->misses(), Misses::none);
            const auto drawn = rendered_mask(run->met(), scene.primitives.size());
            const auto seen = exact_visible_set(scene.primitives, view).visible;
            for (std::size_t p = 0; p < seen.size(); ++p) {
                ASSERT_LE(seen[p], drawn[p]) << settings << " " << view.eye.x << " " << view.eye.y;
                visible += seen[p];
                drawn_in_all += drawn[p];
            }
        }
    };
    for (int i = 0; i < test::soak_count(20); ++i) {
        const ViewpointCase<2> made(random, "samples=1");
        look(made.scene, made.cells, "samples=1 techniques='view; shadow-frusta; coorg-teller'", 450);
    }
    const Scene<2> rooms = make_scene(*find_in_catalogue<2>("rooms"));
    const CellComplex<2> none_needed;
    look(rooms, none_needed, "samples=1 grid=4 techniques='portals; pvs; coorg-teller'", test::soak_count(500));
    look(rooms, none_needed, "samples=1 grid=4 choose_by=paper allotted_ms=0", test::soak_count(500));
    EXPECT_GE(views, 10'000u);
    EXPECT_GT(visible, 20'000u);
    EXPECT_GT(drawn_in_all, visible);
}

// At the centres of an image's pixels.
TEST(ByViewpoint, NothingVisibleIsLostAnywhereInTheVolumesOfEntries3d) {
    Random random(13);
    for (const char* const id : {"soda", "campus"}) {
        const Scene<3> scene = load_scene<3>(id);
        CellComplex<3> cells;
        cells.boxes->of(scene);
        const Variant<3> variant = make_variant<3>(
            method_table<3>(),
            "by-viewpoint samples=1 choose_by=paper allotted_ms=0 techniques='view; shadow-frusta; portals'");
        Services services;
        services.image = {64, 48};
        const auto problem = [&](const View<3>& view) {
            return make_problem(variant.method, variant.parameters, scene, cells, view, none, services);
        };
        const auto table = viewpoint_table<3>(
            method_table<3>(), problem(scene_view(ViewSpec<3>{{0, 0, 0}, {1, 0, 0}, 60}, scene, {64, 48})));
        for (int i = 0; i < test::soak_count(60); ++i) {
            const View<3> view = view_of_an_entry(*table, scene, random);
            const auto run = variant.method.start(problem(view));
            run->run(none);
            const auto drawn = rendered_mask(run->met(), scene.primitives.size());
            const IdImage exact = draw_ids_in_software(scene, view, {64, 48}, 1).front();
            for (const std::uint32_t seen : exact.ids)
                ASSERT_TRUE(seen == none || drawn[seen]) << id << " " << seen;
        }
    }
}

TEST(ByViewpoint, KeepsTheLastTechniqueUntilChangingPays) {
    Random random(13);
    std::size_t kept = 0, changed = 0;
    for (int i = 0; i < test::soak_count(40); ++i) {
        const ViewpointCase<2> made(random, std::string(three) + " switch_ms=0.004 valid_frames=1");
        const Problem<2> first = made.problem(made.view(random));
        const auto before = made.method.start(first);
        before->run(none);
        const Problem<2> second = made.problem(made.view(random), before->next_history());
        const ViewpointRun<2> run(second, made.table(second));
        const std::uint32_t last = dynamic_cast<const ViewpointRun<2>&>(*before).technique();
        const Entry& entry = *run.table().find(run.place());
        const bool pays = 0.004 + entry.facts.costs[entry.chosen].ms() < entry.facts.costs[last].ms();
        ASSERT_EQ(run.technique(), pays ? entry.chosen : last);
        kept += run.keeps_the_last();
        changed += run.technique() != last;
    }
    EXPECT_GT(kept, 0u);
    EXPECT_GT(changed, 0u);
}

TEST(ByViewpoint, RefusesWhatCannotBe) {
    Random random(14);
    const ViewpointCase<2> made(random, "");
    Parameters parameters;
    EXPECT_THROW(parameters.set(techniques_row(), "by-viewpoint"), InputError);
    EXPECT_THROW(parameters.set(techniques_row(), " ; "), InputError);
    EXPECT_THROW(parameters.set(cull_times_row(), "view 40"), InputError);
    EXPECT_THROW(parameters.set(cull_times_row(), "view -1/2"), InputError);
    EXPECT_THROW(ViewpointCase<2>(random, "techniques=nothing").problem(made.view(random)), InputError);
    EXPECT_EQ(cull_time("view 40/8; boxes refresh=1 7/9", "boxes refresh=1"), (CullTime{7, 9}));
    EXPECT_EQ(cull_time("view 40/8; boxes 1/2", "boxes refresh=9"), (CullTime{1, 2}));
}

}  // namespace
}  // namespace sightline
