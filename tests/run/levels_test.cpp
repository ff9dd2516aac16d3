// The method `levels`: what it takes, what stands in, what it says of the frame, and what its pictures show.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/base/number.h"
#include "core/base/trig.h"
#include "core/measure/drawn_image.h"
#include "core/measure/metrics.h"
#include "core/methods/levels/levels_run.h"
#include "core/run/drawn_levels.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/scene_view.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Objects of many primitives each, near and far.
Scene<2> field(Random& random, Vec<2>) {
    Scene<2> scene;
    for (std::uint32_t object = 0; object < 60; ++object) {
        const Vec<2> middle(random.uniform(0, 100), random.uniform(0, 100));
        const int corners = 3 + static_cast<int>(random.below(40));
        const double radius = random.uniform(0.2, 3);
        const auto at = [&](int i) {
            const SinCos turn = sincos_degrees(360.0 * (i % corners) / corners);
            return middle + Vec<2>(turn.cos, turn.sin) * radius;
        };
        for (int i = 0; i < corners; ++i) scene.primitives.push_back({at(i), at(i + 1)});
        scene.objects.names.push_back("round " + std::to_string(object));
        scene.objects.of.resize(scene.primitives.size(), object);
    }
    return scene;
}
Scene<3> field(Random& random, Vec<3>) {
    Scene<3> scene;
    for (std::uint32_t object = 0; object < 60; ++object) {
        const Vec<3> middle(random.uniform(0, 100), random.uniform(0, 100), random.uniform(-2, 2));
        const int n = 2 + static_cast<int>(random.below(10));
        const double radius = random.uniform(0.2, 3);
        const auto at = [&](int i, int j) {  // on a sphere
            const SinCos up = sincos_degrees(180.0 * j / n - 90),
                         turn = sincos_degrees(360.0 * (i % (2 * n)) / (2 * n));
            return middle + Vec<3>(up.cos * turn.cos, up.cos * turn.sin, up.sin) * radius;
        };
        for (int i = 0; i < 2 * n; ++i)
            for (int j = 0; j < n; ++j) {
                if (j > 0) scene.primitives.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                if (j + 1 < n) scene.primitives.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        scene.objects.names.push_back("ball " + std::to_string(object));
        scene.objects.of.resize(scene.primitives.size(), object);
    }
    return scene;
}

template <int D>
struct Landscape {
    Scene<D> scene;
    Settings settings;
    CellComplex<D> cells;
    View<D> view;

    explicit Landscape(Random& random) : scene(field(random, Vec<D>(0))) {
        settings.method = "levels";
        settings.error_bound = 0.5;
        cells = build_cells(scene, settings);
        ViewSpec<D> spec;
        spec.eye = Vec<D>(0), spec.look_at = Vec<D>(0);
        spec.eye[0] = random.uniform(-20, 40), spec.eye[1] = random.uniform(-20, 40);
        spec.look_at[0] = random.uniform(45, 100), spec.look_at[1] = random.uniform(45, 100);
        spec.fov = random.uniform(30, 90);
        view = scene_view(spec, scene, settings.reference_size);
    }
    void set(const char* assignment) { apply_setting(settings, assignment); }
    Problem<D> problem() const {
        Problem<D> made = test::problem_of(scene, cells, view, settings);
        made.services.image = D == 2 ? ImageSize{2048, 0} : ImageSize{320, 240};
        return made;
    }
    const Method<D>& method() const { return find_method<D>(method_table<D>(), "levels"); }
};

template <int D>
const LevelsRun<D>& own(const OwnRun<D>& run) {
    return static_cast<const LevelsRun<D>&>(*run);
}

/// No object in view is lost, none is at a level that is off by more, and no coarser level would have done.
template <int D>
void expect_coarsest_levels() {
    Random random(30 + D);
    std::size_t at_a_level = 0, as_they_are = 0;
    for (int round = 0; round < test::soak_count(10); ++round) {
        Landscape<D> field(random);
        const char* const errors[] = {"pixel_error=0.25", "pixel_error=1", "pixel_error=4"};
        field.set(errors[round % 3]);
        const double allowed = field.settings.parameters.number(pixel_error_row());
        const Problem<D> problem = field.problem();
        OwnRun<D> run(field.method().start(problem));
        ASSERT_EQ(run->run(none), Stop::front_empty);
        const auto levels = run->levels();
        const PixelScale<D> scale(field.view, problem.services.image);
        std::vector<std::uint32_t> level_of(levels->object_count());
        std::uint32_t before = 0, triangles = 0;
        for (const StandIn& stand_in : run->stand_ins()) {
            ASSERT_TRUE(level_of[stand_in.object] == 0 && (before == 0 || stand_in.object >= before));
            before = stand_in.object;
            level_of[stand_in.object] = stand_in.level;
            triangles += levels->at(stand_in.object, stand_in.level).count();
        }
        ASSERT_EQ(triangles, run->counters().stood_in);
        ASSERT_EQ(run->counters().drawn(), run->counters().rendered_count + triangles);
        const auto rendered = rendered_mask(run->met(), field.scene.primitives.size());
        for (std::uint32_t object = 0; object < levels->object_count(); ++object) {
            const auto corners = levels->boxes[object].corners();
            const bool seen = in_view(field.view, std::span<const Vec<D>>(corners));
            ASSERT_EQ(run->mark(Item{object, Kind::object}).state, seen ? CellState::projected : CellState::unseen);
            const auto error = [&](std::uint32_t level) {
                return levels->at(object, level).error * scale.pixels_per_unit(levels->boxes[object]);
            };
            const std::uint32_t level = level_of[object];
            if (level > 0) {
                ++at_a_level;
                ASSERT_TRUE(seen);
                ASSERT_LE(error(level), allowed);
            }
            if (seen && level < levels->of(object).size()) {
                ASSERT_GT(error(level + 1), allowed);
            }
            for (const std::uint32_t p : levels->primitives_of(object)) {
                ASSERT_EQ(rendered[p], seen && level == 0 && shows(problem, p)) << "drawn twice, or lost";
                as_they_are += rendered[p];
            }
        }
    }
    EXPECT_GT(at_a_level, 50u);
    EXPECT_GT(as_they_are, 50u);
}
TEST(LevelsMethod, TakesTheCoarsestLevelThatLooksAlike2d) { expect_coarsest_levels<2>(); }
TEST(LevelsMethod, TakesTheCoarsestLevelThatLooksAlike3d) { expect_coarsest_levels<3>(); }

/// From far to near; the predicted time never rises, falls with each level, and once it is low enough nothing more is
/// made coarser.
template <int D>
void expect_falling_costs() {
    Random random(40 + D);
    std::size_t coarser = 0, enough = 0;
    for (int round = 0; round < test::soak_count(8); ++round) {
        Landscape<D> field(random);
        field.set("pixel_error=4");
        field.set("pixel_ns=0.01");  // vertices decide
        if (round % 2) field.set("cost=max-of-sums");
        Problem<D> problem = field.problem();
        OwnRun<D> whole(field.method().start(problem));
        whole->run(none);
        const CostReading reading = field.settings.parameters.template choice<CostReading>(cost_row());
        const double first = own(whole).frame_ms(0, reading), last = own(whole).frame_ms(whole->steps(), reading);
        const double target = round == 0 ? 0 : last + (first - last) * random.uniform(0, 1);
        problem.parameters.set(frame_ms_row(), number_text(target));
        test::Recorded<D> recorded = test::record_all(field.method(), problem);
        const LevelsRun<D>& run = own(recorded.run);
        double distance = std::numeric_limits<double>::infinity();
        bool done = false;
        for (std::uint32_t step = 1; step <= recorded.timeline.size(); ++step) {
            const Step& at = recorded.timeline.steps[step - 1];
            ASSERT_EQ(at.item.kind, Kind::object);
            const double away = std::sqrt(squared_distance(run.levels()->boxes[at.item.id], field.view.eye));
            ASSERT_LE(away, distance);
            distance = away;
            const double before = run.frame_ms(step - 1, reading), after = run.frame_ms(step, reading);
            const auto rule = LevelRule{recorded.timeline.changes_of(step).front().rule};
            done = done || (target > 0 && before <= target);
            ASSERT_EQ(rule == LevelRule::coarser, after < before);
            ASSERT_LE(after, before);
            if (done) {
                ASSERT_EQ(rule, LevelRule::enough);
            }
            coarser += rule == LevelRule::coarser;
            enough += rule == LevelRule::enough;
            ASSERT_NE(run.popped_words(at).find(" ms"), std::string::npos);
        }
    }
    EXPECT_GT(coarser, 20u);
    EXPECT_GT(enough, 20u);
}
TEST(LevelsMethod, GoesFromFarToNearUntilTheFrameIsQuickEnough2d) { expect_falling_costs<2>(); }
TEST(LevelsMethod, GoesFromFarToNearUntilTheFrameIsQuickEnough3d) { expect_falling_costs<3>(); }

/// What stands in goes back and forth with the steps.
template <int D>
void expect_walks() {
    Random random(50 + D);
    for (int round = 0; round < test::soak_count(6); ++round) {
        Landscape<D> field(random);
        if (round % 2) field.set("frame_ms=0.001");
        Problem<D> problem = field.problem();
        if (round % 3 == 0) problem.budget = 200;
        test::Recorded<D> recorded = test::record_all(field.method(), problem);
        for (int i = 0; i < 40; ++i) {
            const auto step = static_cast<std::uint32_t>(random.below(recorded.timeline.size() + 1));
            recorded.timeline.seek(recorded.run, step);
            const auto fresh = field.method().start(problem);
            fresh->run(step);
            const auto here = recorded.run->stand_ins(), there = fresh->stand_ins();
            ASSERT_TRUE(std::equal(here.begin(), here.end(), there.begin(), there.end()));
            ASSERT_EQ(recorded.run->counters(), fresh->counters());
            ASSERT_EQ(recorded.run->hash(), fresh->hash());
        }
    }
}
TEST(LevelsMethod, WhatStandsInGoesBackAndForth2d) { expect_walks<2>(); }
TEST(LevelsMethod, WhatStandsInGoesBackAndForth3d) { expect_walks<3>(); }

/// Pictures are compared by objects: with levels that look alike few pixels are wrong, by primitives nearly all that
/// show a level would be; without levels nothing changes.
template <int D>
void expect_alike_pictures() {
    Random random(60 + D);
    double by_objects = 0, by_primitives = 0, found = 0;
    std::size_t levels = 0;
    const int rounds = test::soak_count(6);
    for (int round = 0; round < rounds; ++round) {
        Landscape<D> field(random);
        field.set("pixel_error=2");
        const Problem<D> problem = field.problem();
        const Reference reference =
            make_reference(field.scene, field.cells, field.view, problem.services.image, DrawIds{});
        const auto run = field.method().start(problem);
        ASSERT_EQ(wrong_pixels(reference, *run, {}), wrong_pixels(reference, run->met())) << "nothing stands in yet";
        run->run(none);
        levels += run->stand_ins().size();
        by_objects += wrong_pixels(reference, *run, {});
        by_primitives += wrong_pixels(reference, run->met());
        found += coverage(reference, visible_found(reference, *run)).value_or(1);

        const auto all = find_method<D>(method_table<D>(), "everything").start(problem);
        all->run(none);
        ASSERT_EQ(wrong_pixels(reference, *all, {}), 0);
        // A picture by which some objects are missing is wrong where they should be.
        Problem<D> none_of_it = problem;
        none_of_it.budget = 0;
        const auto empty = field.method().start(none_of_it);
        empty->run(none);
        const auto shown = std::count_if(reference.image.ids.begin(), reference.image.ids.end(),
                                         [](std::uint32_t id) { return id != none; });
        ASSERT_EQ(wrong_pixels(reference, *empty, {}),
                  static_cast<double>(shown) / static_cast<double>(reference.image.ids.size()));
    }
    EXPECT_GT(levels, 20u);
    EXPECT_LT(by_objects, by_primitives / 4);
    EXPECT_LT(by_objects / rounds, 0.03);
    EXPECT_GT(found / rounds, 0.99);
}
TEST(LevelsMethod, PicturesAreComparedByObjects2d) { expect_alike_pictures<2>(); }
TEST(LevelsMethod, PicturesAreComparedByObjects3d) { expect_alike_pictures<3>(); }

/// Ids of what is drawn are those of the scene with its levels.
TEST(LevelsMethod, DrawsThePrimitivesOfLevels) {
    Random random(7);
    Landscape<3> field(random);
    const auto shared = std::make_shared<const Scene<3>>(field.scene);
    Problem<3> problem = field.problem();
    problem.scene = shared.get();
    const auto run = field.method().start(problem);
    run->run(none);
    std::vector<std::uint32_t> ids;
    drawn_ids(*run, ids);
    EXPECT_EQ(ids.size(), run->counters().drawn());
    const auto drawn = drawn_scene(*run, shared);
    std::set<std::uint32_t> objects;
    for (const std::uint32_t id : ids) {
        ASSERT_LT(id, drawn->primitives.size());
        if (id >= shared->primitives.size()) objects.insert(drawn->objects.of[id]);
    }
    EXPECT_EQ(objects.size(), run->stand_ins().size());
    const auto other =
        find_method<3>(method_table<3>(), "view")
            .start(make_problem(find_method<3>(method_table<3>(), "view"), {}, *shared, field.cells, field.view));
    EXPECT_EQ(drawn_scene(*other, shared), shared);
}

}  // namespace
}  // namespace sightline
