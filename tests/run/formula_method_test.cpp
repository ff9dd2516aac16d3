// A heuristic that is typed beside the one that is compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/methods/cells/seed_cells.h"
#include "core/space/builders.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::problem_of, test::record_all, test::Recorded;

template <int D>
Recorded<D> run_of(const std::string& variant, const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view,
                   Settings settings) {
    const Variant<D> made = make_variant<D>(method_table<D>(), variant, settings.parameters);
    settings.parameters = made.parameters;
    return record_all(made.method, problem_of(scene, cells, view, settings));
}

TEST(FormulaMethod, TakesTheStepsOfSolidityWithoutAPenalty) {
    Random random(23);
    std::size_t steps = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        const Settings settings = test::random_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Recorded<2> typed = run_of<2>("formula key=content+angle*handed_on", scene, cells, view, settings);
        const Recorded<2> compiled = run_of<2>("published penalty=none", scene, cells, view, settings);
        ASSERT_EQ(typed.run->hash(), compiled.run->hash()) << "scene " << i;
        ASSERT_EQ(test::popped_cells(typed.timeline), test::popped_cells(compiled.timeline));
        const Recorded<2> whole =
            run_of<2>("formula key=\"(content + angle * handed_on) * (star ? 1 : 2)\"", scene, cells, view, settings);
        const Recorded<2> doubled =
            run_of<2>("published penalty=multiply penalty_amount=2 star_shaped=on", scene, cells, view, settings);
        ASSERT_EQ(whole.run->hash(), doubled.run->hash()) << "scene " << i;
        steps += typed.timeline.size();
    }
    for (int i = 0; i < test::soak_count(10); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, 60);
        const Settings settings = test::random_settings(random);
        const CellComplex<3> cells = build_cells(scene, settings);
        const View<3> view = make_view(ViewSpec<3>{{random.uniform(-1, 2), .4, .3}, {.5, .5, .5}, 60}, 4.0 / 3);
        ASSERT_EQ(run_of<3>("formula key=content+angle*handed_on", scene, cells, view, settings).run->hash(),
                  run_of<3>("published penalty=none", scene, cells, view, settings).run->hash());
    }
    EXPECT_GT(steps, 1000u);
}

TEST(FormulaMethod, HopsAreLayersAndEveryTermIsANumber) {
    Random random(24);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        Settings settings = test::random_settings(random);
        apply_setting(settings, "outside_view=enqueue");  // else a layer may have to go round what is out of view
        apply_setting(settings, "on_reenqueue=min");
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        ASSERT_EQ(test::popped_cells(run_of<2>("formula key=hops", scene, cells, view, settings).timeline),
                  test::popped_cells(run_of<2>("layers", scene, cells, view, settings).timeline));
        const Recorded<2> all =
            run_of<2>("formula key=content+angle+handed_on+star+own_content+facing+depth+distance+hops+area", scene,
                      cells, view, settings);
        for (const auto& [item, mark] : all.run->front()) ASSERT_TRUE(std::isfinite(mark.key));
        for (const Step& step : all.timeline.steps) ASSERT_TRUE(std::isfinite(step.key));
    }
}

TEST(FormulaMethod, AKeyThatIsNoNumberComesLast) {
    Random random(25);
    const Scene<2> scene = test::random_scene(random, 60);
    const Settings settings;
    const CellComplex<2> cells = build_cells(scene, settings);
    const View<2> view = make_view(ViewSpec<2>{{.5, .5}, {1, .5}, 90});
    const Recorded<2> run = run_of<2>("formula key=\"star ? 0/0 : 0\"", scene, cells, view, settings);
    bool came = false;
    for (const Step& step : run.timeline.steps) {
        if (came) {
            EXPECT_TRUE(std::isinf(step.key)) << "after the first of them only they are left, or what they led to";
        }
        came |= std::isinf(step.key) && step.runner_up.kind == Kind::none;
    }
    EXPECT_EQ(run.run->counters().front_size, 0u);
}

TEST(FormulaMethod, RefusesWhatIsNoExpressionOverItsTerms) {
    for (const char* const bad : {"formula key=rho+1", "formula key=", "formula key=sin(content)", "formula key=(1",
                                  "formula content", "formula nokey=1", "formula =1"})
        EXPECT_THROW(make_variant<2>(method_table<2>(), bad), InputError) << bad;
    try {
        make_variant<2>(method_table<2>(), "formula key=contents*2");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean content"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace sightline
