// What must hold for every row of the method table: a method is tested by being there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/space/builders.h"
#include "examples/added_heuristic/methods.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Another run, of which nobody is told that it undoes by marks: the timeline has to keep keyframes.
template <int D>
class WithoutMarks final : public Run<D> {
public:
    explicit WithoutMarks(std::unique_ptr<Run<D>> inner) : Run<D>(inner->problem()), inner_(std::move(inner)) {
        take();
    }
    Stop run(std::uint32_t steps, Recorder* recorder) override {
        inner_->set_budget(this->problem_.budget);
        const Stop stop = inner_->run(steps, recorder);
        take();
        return stop;
    }
    bool finished() const override { return inner_->finished(); }
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<WithoutMarks>(inner_->clone()); }
    std::size_t memory_bytes() const override { return inner_->memory_bytes(); }
    std::uint64_t hash() const override { return inner_->hash(); }

private:
    void take() {
        this->drawn_ = inner_->drawn();
        this->counters_ = inner_->counters();
        this->steps_ = inner_->steps();
    }
    std::unique_ptr<Run<D>> inner_;
};

template <int D>
struct Case {
    Scene<D> scene;
    CellComplex<D> cells;
    Settings settings;
    View<D> view;

    Problem<D> problem() const { return test::problem_of(scene, cells, view, settings); }
};

/// A scene, cells and a view of which nothing is known.
template <int D>
Case<D> random_case(Random& random) {
    Case<D> made;
    made.settings = test::random_wide_settings(random);
    if constexpr (D == 2) {
        made.scene = test::random_scene(random, random.below(100));
        made.view = make_view(test::random_view(random));
    } else {
        made.scene = test::random_scene_3d(random, 60);
        const double x = random.uniform(-1, 2), y = random.uniform(-1, 2), z = random.uniform(-1, 2);
        made.view = make_view(ViewSpec<3>{{x, y, z}, {.5, .5, .5}, 60}, 4.0 / 3);
    }
    made.cells = build_cells(made.scene, made.settings);
    return made;
}

/// Those of the table and of the examples that need no more than a scene, or what problem_of gives.
template <int D>
const std::vector<Method<D>>& all_methods() {
    static const std::vector<Method<D>> methods = methods_of_ones_own<D>();
    return methods;
}
template <int D>
std::vector<Method<D>> runnable() {
    std::vector<Method<D>> methods;
    for (const Method<D>& method : all_methods<D>())
        if (D == 2 || !method.needs.visible_set) methods.push_back(method);
    return methods;
}

/// Hash after every step, forward only and without a recording.
template <int D>
std::vector<std::uint64_t> forward_hashes(const Method<D>& method, const Problem<D>& problem) {
    const std::unique_ptr<Run<D>> run = method.start(problem);
    std::vector<std::uint64_t> hashes{run->hash()};
    while (run->run(1) == Stop::steps) hashes.push_back(run->hash());
    return hashes;
}

/// Steps, goes back, seeks; at every stop the hash is that of going forward only.
template <int D>
void walk(const Method<D>& method, const Problem<D>& problem, OwnRun<D> run, Random& random) {
    const std::vector<std::uint64_t> hashes = forward_hashes(method, problem);
    Timeline<D> timeline;
    timeline.begin(*run);
    ASSERT_EQ(run->hash(), hashes.front());
    const auto last = static_cast<std::uint32_t>(hashes.size() - 1);
    for (int move = 0; move < 40; ++move) {
        const auto target = static_cast<std::uint32_t>(random.below(hashes.size()));
        if (random.below(3) == 0 && target <= timeline.size()) timeline.seek(run, target);
        while (run->steps() > target && random.below(50) > 0) {
            ASSERT_TRUE(timeline.back(run));
            ASSERT_EQ(run->hash(), hashes[run->steps()]) << method.id << ", back";
        }
        while (run->steps() < target && random.below(50) > 0) {
            ASSERT_EQ(timeline.forward(run), Stop::none);
            ASSERT_EQ(run->hash(), hashes[run->steps()]) << method.id << ", forward";
        }
        if (run->steps() > 0 && random.below(4) == 0) {  // into the step, on a clone
            const std::uint32_t step = run->steps();
            OwnRun<D> into = run;
            const auto changes = std::as_const(timeline).changes_of(step);
            const std::uint32_t substeps = run->substeps(timeline.steps[step - 1], changes);
            for (std::uint32_t substep = 0; substep + 1 < substeps; ++substep) {
                into = run;
                Step copy = timeline.steps[step - 1];
                std::vector<Change> kept(changes.begin(), changes.end());
                into->rewind_to(copy, kept, timeline.before(step), substep);
                ASSERT_LE(kept.size(), changes.size());
                ASSERT_LE(into->counters().rendered_count, run->counters().rendered_count);
            }
            ASSERT_EQ(run->hash(), hashes[step]) << method.id << ": a substep changed the run itself";
        }
        if (random.below(4) == 0) {  // going on without the recording finds the same order
            const OwnRun<D> branch = run;
            const std::unique_ptr<Run<D>> rest = branch->clone();
            while (rest->run(5) == Stop::steps) {
            }
            ASSERT_EQ(rest->hash(), hashes.back()) << method.id << ", branch";
            ASSERT_TRUE(rest->finished());
        }
        ASSERT_LE(run->steps(), last);
    }
}

/// Of a variant of it.
template <int D>
void test_method(std::string_view text, std::uint64_t seed) {
    Random random(seed);
    OwnRun<D> reused;
    const VariantText variant = read_variant(text);
    for (int i = 0; i < test::soak_count(D == 2 ? 60 : 12); ++i) {
        Case<D> made = random_case<D>(random);
        const Method<D>& method = find_variant<D>(all_methods<D>(), variant, made.settings.parameters);
        const Problem<D> problem = made.problem();
        walk<D>(method, problem, OwnRun<D>(method.start(problem)), random);
        walk<D>(method, problem, OwnRun<D>(std::make_unique<WithoutMarks<D>>(method.start(problem))), random);
        if (testing::Test::HasFatalFailure()) return;

        const test::Recorded<D> recorded = test::record_all(method, problem);
        reused.start(problem, method.start);
        reused->run(none);
        ASSERT_EQ(recorded.run->hash(), reused->hash())
            << method.id << ": recording, or memory of another run, matters";

        // What it was given serves another run as well: nothing of the method's own is in it.
        const Problem<D>& given = recorded.run->problem();
        ASSERT_EQ(given.services.image, problem.services.image) << method.id;
        const std::unique_ptr<Run<D>> again = method.start(given);
        again->run(none);
        ASSERT_EQ(recorded.run->hash(), again->hash()) << method.id;

        // A budget selects a prefix of the same order, and a larger one goes on where it ended.
        Problem<D> unlimited = problem;
        unlimited.budget = none;
        const std::unique_ptr<Run<D>> whole = method.start(unlimited);
        whole->run(none);
        Problem<D> small = problem;
        small.budget = static_cast<std::uint32_t>(random.below(20));
        const std::unique_ptr<Run<D>> run = method.start(small);
        while (method.prefixes) {
            const Stop stop = run->run(none);
            if (test::choice<BudgetCounts>(made.settings, budget_counts_row()) == BudgetCounts::each_once) {
                ASSERT_LE(run->counters().spent, run->problem().budget);
            }
            const auto met = run->met();
            ASSERT_TRUE(std::equal(met.begin(), met.end(), whole->met().begin())) << method.id;
            if (stop != Stop::budget) break;
            run->set_budget(run->problem().budget + 1 + static_cast<std::uint32_t>(random.below(20)));
        }
        if (method.prefixes) {
            ASSERT_EQ(run->hash(), whole->hash()) << method.id << ": something was done twice on the way";
        }

        // What it says is words, whatever is asked; a run that misses nothing has rendered all that is visible.
        for (std::uint32_t step = 1; step <= recorded.timeline.size(); ++step)
            for (const Considered& c :
                 recorded.run->considered(recorded.timeline.steps[step - 1], recorded.timeline.changes_of(step), 3)) {
                ASSERT_FALSE(c.words.empty()) << method.id;
            }
        if constexpr (D == 2)
            if (whole->misses() == Misses::none) {
                const auto rendered = rendered_mask(whole->met(), made.scene.primitives.size());
                const auto visible = visible_set<2>(made.scene, made.view, {}, {});
                for (std::size_t p = 0; p < visible.size(); ++p) ASSERT_LE(visible[p], rendered[p]) << method.id;
            }
        if (method.prefixes && run->counters().spent < whole->counters().spent) {
            ASSERT_EQ(run->misses(), Misses::may) << method.id;
        }
    }
}

class EveryMethod2d : public testing::TestWithParam<std::string_view> {};
class EveryMethod3d : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryMethod2d, WalksBackAndForthWithTheHashesOfGoingForward) { test_method<2>(GetParam(), 13); }
TEST_P(EveryMethod3d, WalksBackAndForthWithTheHashesOfGoingForward) { test_method<3>(GetParam(), 18); }

template <int D>
std::vector<std::string_view> ids() {
    std::vector<std::string_view> found;
    for (const Method<D>& method : runnable<D>()) found.push_back(method.id);
    // Those that do other things than their method does by default.
    for (const char* variant : {"cplp test=item", "cplp test=item listing=printed", "cplp total=12",
                                "cplp test=item total=30% draws=winners"})
        found.push_back(variant);
    return found;
}
std::string name_of(const testing::TestParamInfo<std::string_view>& info) {
    std::string name;
    for (const char c : info.param)
        if (c != '%') name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod2d, testing::ValuesIn(ids<2>()), name_of);
INSTANTIATE_TEST_SUITE_P(Table, EveryMethod3d, testing::ValuesIn(ids<3>()), name_of);

}  // namespace
}  // namespace sightline
