// The trade-off of speed and accuracy, measured slice by slice, and when it begins anew.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/measure/frame_before.h"
#include "core/measure/wrong_region.h"
#include "core/scene/scene_view.h"
#include "shell/commands/command_table.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/moves.h"
#include "shell/panels/panel_table.h"
#include "shell/window/trade_off_plot.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using namespace test;
/// Of the table.
constexpr std::size_t published_row = 0, layers_row = 1, view_row = 3;
using M = Measure;

template <int D>
TradeOffTask<D> task_of(const Session<D>& session, std::size_t views, Random& random) {
    TradeOffTask<D> task{session.shared_scene(), session.shared_cells(), session.settings().reference_size, {}, {}};
    ViewSpec<D> spec = session.culling_view();
    for (std::size_t i = 0; i < views; ++i) {
        task.views.push_back(scene_view(spec, session.scene(), session.settings().reference_size));
        task.before.push_back(i == 0 ? task.views[0] : task.views[i - 1]);
        for (int c = 0; c < D; ++c) spec.eye[c] += random.uniform(-0.2, 0.2);
    }
    for (const Method<D>& method : method_table<D>())
        if (method.compared)
            task.variants.push_back(variant_of(method, session.settings().parameters, session.settings().parameters));
    return task;
}

/// Every dot against one whole run per view and method, without slices.
template <int D>
void check_all(const TradeOffStudy<D>& study) {
    const TradeOffTask<D>& task = study.task();
    const CellComplex<D>* const cells = task.cells.get();
    for (std::size_t v = 0; v < task.views.size(); ++v) {
        const auto truths = make_truths<D>(*task.scene, {&cells, 1}, task.views[v], task.reference_size, task.draw_ids);
        for (const TradeOffDot& dot : study.dots()) {
            const Variant<D>& variant = task.variants[dot.variant];
            Problem<D> problem = make_problem(variant.method, variant.parameters, *task.scene, *cells, task.views[v],
                                              none, known_services({}, task.reference_size));
            problem.history = frame_history<D>(variant.method, problem, task.before[v]);
            const WholeRun run = whole_run<D>(variant.method, problem, truths[0].reference);
            const auto all = static_cast<std::uint32_t>(task.scene->primitives.size());
            const std::uint32_t k = std::min(all, dot.budget.primitives(all));
            const auto rendered = rendered_by(run, cut_at(run, k).met, all);
            const Values expected = frame_numbers(run, truths[0], k, rendered,
                                                  wrong_mask(truths[0].reference.image, rendered), std::nullopt);
            const Values& found = dot.frames.at(v);
            for (const M m : {M::budget, M::rendered, M::visible, M::coverage, M::coverage_px, M::oracle, M::wrong,
                              M::blob, M::k95, M::efficiency, M::steps, M::front}) {
                const double a = found[m], b = expected[m];
                EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << measure_row(m).id << " " << a << " " << b;
            }
            EXPECT_TRUE(std::isnan(found[M::zeta])) << "layering numbers are not made";
            EXPECT_GE(found[M::traverse_ms], 0);
            const double drawing = std::isnan(found[M::draw_ms]) ? 0 : found[M::upload_ms] + found[M::draw_ms];
            EXPECT_DOUBLE_EQ(found[M::total_ms], found[M::traverse_ms] + drawing);
        }
    }
}

TEST(TradeOff, IsInSlicesWhatItIsAtOnce) {
    Random random(61);
    for (int i = 0; i < 6; ++i) {
        Start start = random_start(random, 90);
        start.settings.budget = {};
        const Session<2> session = start.session();
        TradeOffStudy<2> study(task_of(session, 2, random));
        study.ask(study.task().variants[published_row], {Budget::Kind::primitives, 7});
        std::size_t done = 0, slices = 0;
        while (study.advance()) {
            ASSERT_LE(study.done(), done + 1) << "a slice is more than one frame of one dot";
            ASSERT_GE(study.done(), done);
            done = study.done();
            ++slices;
        }
        EXPECT_TRUE(study.finished());
        EXPECT_EQ(study.done(), study.total());
        EXPECT_GT(slices, 5 * study.total()) << "an image, a run, its numbers and four times cannot be fewer";
        EXPECT_FALSE(study.advance());
        check_all(study);
    }
    for (int i = 0; i < 3; ++i) {
        Start3 start = random_start_3d(random);
        const Session<3> session = start.session();
        TradeOffTask<3> task = task_of(session, 2, random);
        task.draw_ids = cast_rays;
        constexpr std::array draw_ms{100.0, 5.0, 1.0, 3.0};  // the first one warms up
        std::vector<std::size_t> drawn;                      // how many triangles each time
        task.time_drawing = [&](const auto&, const View<3>&, std::span<const std::uint32_t> ids) {
            const double ms = draw_ms[drawn.size() % 4];
            drawn.push_back(ids.size());
            return DrawTimes{2 * ms, ms};
        };
        TradeOffStudy<3> study(std::move(task));
        std::vector<std::size_t> before(study.dots().size());
        for (std::size_t times = 0; study.advance(); times = drawn.size()) {
            ASSERT_LE(drawn.size(), times + 1) << "a slice draws twice";
            for (std::size_t d = 0; d < before.size(); ++d) {
                const TradeOffDot& dot = study.dots()[d];
                if (std::exchange(before[d], dot.frames.size()) == dot.frames.size()) continue;
                ASSERT_EQ(drawn.size(), 4 * study.done());
                for (std::size_t t = drawn.size() - 4; t < drawn.size(); ++t)
                    EXPECT_EQ(static_cast<double>(drawn[t]), dot.frames.back()[M::rendered]) << "something else";
            }
        }
        check_all(study);
        for (const TradeOffDot& dot : study.dots()) {
            EXPECT_EQ(dot.frames[0][M::upload_ms], 6);
            EXPECT_EQ(dot.frames[0][M::draw_ms], 3);
        }
    }
}

TEST(TradeOff, ComparesDotsOverTheViewsThatAllHave) {
    Random random(62);
    const Session<2> session = random_start(random, 90).session();
    TradeOffStudy<2> study(task_of(session, 3, random));
    std::size_t ahead = 0;  // dots whose own frames have another mean
    while (study.advance()) {
        const std::size_t count = std::max<std::size_t>(study.common_views(), 1);
        for (const TradeOffDot& dot : study.dots()) {
            const double value = study.value(dot, M::visible);
            if (dot.frames.size() < count) {
                ASSERT_TRUE(std::isnan(value));
                continue;
            }
            double mean = 0;
            for (std::size_t f = 0; f < count; ++f) mean += dot.frames[f][M::visible] / static_cast<double>(count);
            ASSERT_NEAR(value, mean, 1e-9);
            ahead += std::abs(summary(dot.frames, M::visible) - mean) > 1e-9;
        }
    }
    EXPECT_EQ(study.common_views(), 3u);
    EXPECT_GT(ahead, 0u);
}

TEST(TradeOff, MeasuresTheBudgetThatIsAskedForToo) {
    Random random(63);
    const Session<2> session = random_start(random, 90).session();
    TradeOffStudy<2> study(task_of(session, 1, random));
    const std::size_t usual = study.dots().size();
    EXPECT_EQ(usual, 7u * 4 + 9) << "four budgets for each approximate method, none for the others";
    std::vector<double> shares;
    for (const TradeOffDot& dot : study.dots())
        if (dot.variant == 0) shares.push_back(dot.budget.value);
    EXPECT_EQ(shares, (std::vector{0.01, 0.02, 0.05, 0.10}));
    study.ask(study.task().variants[layers_row], {Budget::Kind::share, 0.05});
    EXPECT_EQ(study.dots().size(), usual) << "it is there already";
    study.ask(study.task().variants[layers_row], {Budget::Kind::milliseconds, 5});
    study.ask(study.task().variants[view_row], {Budget::Kind::share, 0.3});
    EXPECT_EQ(study.dots().size(), usual);
    study.ask(study.task().variants[layers_row], {Budget::Kind::share, 0.5});
    ASSERT_EQ(study.dots().size(), usual + 1);
    while (study.advance()) {
    }
    study.ask(study.task().variants[layers_row], {Budget::Kind::share, 0.5});
    EXPECT_TRUE(study.finished()) << "it was dropped and made again";
    study.ask(study.task().variants[published_row], {});
    ASSERT_EQ(study.dots().size(), usual + 1) << "what was asked for before stays";
    EXPECT_FALSE(study.finished());
    while (study.advance()) {
    }
    EXPECT_EQ(study.dots().back().frames[0][M::budget], static_cast<double>(session.scene().primitives.size()));
    check_all(study);
}

class TradeOffOf : public Commands {
protected:
    void finish() { run("trade-off finish"); }
    const TradeOffStudy<2>& study() const { return bench->trade_off.study; }
    std::string word() {
        update_trade_off(*bench);
        return bench->trade_off.word;
    }
};

TEST_F(TradeOffOf, BeginsAnewWhereItMustAndSaysWhy) {
    finish();
    ASSERT_TRUE(study().finished());
    EXPECT_EQ(word(), "");
    const std::size_t done = study().done();
    for (const char* harmless : {"method layers; budget 5%", "set show_normals=on", "step 5", "trade-off coverage"}) {
        run(harmless);
        EXPECT_EQ(word(), "") << harmless;
        EXPECT_EQ(study().done(), done) << harmless;
    }
    const std::array<std::pair<const char*, const char*>, 4> changes{
        std::pair{"set error_bound=0.2", "restarted: another tessellation"},
        {"set reference_size=640", "restarted: another reference size"},
        {"eye 30,30", "restarted: the view moved"},
        {"segment add 1,1 2,2", "restarted: another scene"}};
    for (const auto& [command, why] : changes) {
        run(command);
        EXPECT_EQ(word(), why) << command;
        EXPECT_EQ(study().done(), 0u);
        finish();
    }
    bench->flight.path = {"round", {bench->session.culling_view(), bench->session.culling_view()}, {}, {}};
    EXPECT_EQ(word(), "restarted: another path");
    EXPECT_EQ(study().task().views.size(), 2u);
}

TEST_F(TradeOffOf, StopsKeepsWhatItHasAndGoesOn) {
    while (study().done() < 5) advance_trade_off(*bench, 0.01);
    run("trade-off stop");
    const std::size_t done = study().done();
    EXPECT_FALSE(advance_trade_off(*bench, 50));
    EXPECT_EQ(study().done(), done);
    run("trade-off go");
    EXPECT_TRUE(advance_trade_off(*bench, 0.01));
    finish();
    EXPECT_TRUE(study().finished());
    run("trade-off restart");
    EXPECT_EQ(study().done(), 0u);
}

TEST_F(TradeOffOf, SaysHowFarItIsAndHowLongItStillTakes) {
    update_trade_off(*bench);
    const std::string total = " of " + std::to_string(study().total());
    EXPECT_EQ(trade_off_progress_text(*bench), "0" + total) << "nothing tells how long it takes";
    while (study().done() < 5) {
        const TradeOffDot* const next = study().next_dot();
        ASSERT_TRUE(next);
        EXPECT_EQ(trade_off_work_text(*bench), "measuring " + study().task().variants[next->variant].text + " " +
                                                   budget_text(next->budget) + ", frame 1 of 1");
        const std::size_t frames = next->frames.size(), done = study().done();
        bench->trade_off.study.advance();
        EXPECT_EQ(study().done() - done, next->frames.size() - frames) << "another dot was measured";
    }
    bench->trade_off.spent_ms = 5 * 13'000;
    EXPECT_EQ(trade_off_progress_text(*bench),
              "5" + total + ", about " + duration_text(13.0 * static_cast<double>(study().total() - 5)) + " left");
    run("play");
    EXPECT_EQ(trade_off_progress_text(*bench), "5" + total + ", paused during playback and flight");
    EXPECT_EQ(trade_off_work_text(*bench), "");
    run("pause; trade-off stop");
    EXPECT_EQ(trade_off_progress_text(*bench), "5" + total + ", stopped");
    EXPECT_EQ(trade_off_work_text(*bench), "");
    const auto rows = trade_off_rows(*bench);
    EXPECT_EQ(rows[1].text, "measured: 5" + total + ", stopped (click to continue)");
    EXPECT_EQ(rows[1].command, "trade-off go");
    run("trade-off go");
    advance_trade_off(*bench, 5);
    EXPECT_GT(bench->trade_off.spent_ms, 5 * 13'000);
    run("set reference_size=640");
    update_trade_off(*bench);
    EXPECT_EQ(bench->trade_off.spent_ms, 0) << "what was measured before takes no time of this";
    EXPECT_EQ(trade_off_progress_text(*bench), "0" + total);
    finish();
    EXPECT_EQ(trade_off_rows(*bench)[1].text, "measured all " + std::to_string(study().total()));
    EXPECT_EQ(trade_off_work_text(*bench), "");
}

TEST(DurationText, IsForPeople) {
    EXPECT_EQ(duration_text(0.2), "0 s");
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(59.6), "1 min 0 s");
    EXPECT_EQ(duration_text(185), "3 min 5 s");
}

TEST_F(TradeOffOf, ItsRowsSayWhatTheStudyHas) {
    finish();
    const auto rows = trade_off_rows(*bench);
    for (const TradeOffDot& dot : study().dots()) {
        const std::string name = study().task().variants[dot.variant].text + " " + budget_text(dot.budget) + ": ";
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.text.starts_with(name); });
        ASSERT_NE(row, rows.end()) << name;
        const auto number = [&](M measure, double unit) { return short_number(unit * study().value(dot, measure)); };
        EXPECT_EQ(row->text.find(name + milliseconds_text(study().value(dot, M::total_ms)) + ", wrong " +
                                 number(M::wrong, 100) + " %, coverage " + number(M::coverage, 100) + " %"),
                  0u)
            << row->text;
    }
    EXPECT_EQ(rows[0].text, "bottleneck, current view only");
    Scene<2> other = session().scene();
    other.id = "other";
    bench->session =
        Session<2>(std::make_shared<const Scene<2>>(other), session().culling_view(), session().settings());
    EXPECT_EQ(trade_off_rows(*bench)[0].text, "bottleneck, current view only") << "of what was measured";
    update_trade_off(*bench);
    EXPECT_EQ(trade_off_rows(*bench)[0].text, "other, current view only");
}

/// The front has each dot that no other one beats: in time, and in the direction that is better.
TEST_F(TradeOffOf, FrontIsWhatNoDotBeats) {
    finish();
    for (const M shown : {M::wrong, M::coverage}) {
        run(shown == M::wrong ? "trade-off wrong" : "trade-off coverage");
        const double sign = shown == M::wrong ? -1 : 1;
        const auto& dots = study().dots();
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const double ms = study().value(dots[i], M::total_ms), value = sign * study().value(dots[i], shown);
            const bool beaten = std::any_of(dots.begin(), dots.end(), [&](const TradeOffDot& other) {
                const double other_ms = study().value(other, M::total_ms), v = sign * study().value(other, shown);
                return other_ms <= ms && v >= value && (other_ms < ms || v > value);
            });
            if (!beaten) expected.push_back(i);
        }
        std::vector<std::size_t> front = pareto_dots(*bench);
        std::sort(front.begin(), front.end());
        EXPECT_EQ(front, expected);
        ASSERT_GE(front.size(), 2u);
        ASSERT_LT(front.size(), dots.size());
    }
}

TEST_F(TradeOffOf, GoesAlongThePathOrStaysWithTheView) {
    update_trade_off(*bench);
    EXPECT_EQ(study().task().views.size(), 1u);
    EXPECT_EQ(study().task().views[0].eye, session().culling_view().eye);
    ViewSpec<2> view = session().culling_view();
    bench->flight.path.id = "far";
    for (int i = 0; i < 29; ++i) {
        view.eye += Vec<2>(0.25, 0.125);
        bench->flight.path.frames.push_back(view);
    }
    update_trade_off(*bench);
    EXPECT_EQ(bench->trade_off.path, "path far, 8 of 29 frames");
    ASSERT_EQ(study().task().views.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(study().task().views[i].eye, bench->flight.path.frames[4 * i].eye) << "frame " << 4 * i;
}

TEST_F(TradeOffOf, WaitsWhileSomethingMoves) {
    EXPECT_TRUE(stands_still(*bench));
    run("play");
    EXPECT_FALSE(stands_still(*bench));
    run("pause");
    bench->flight.on = true;
    EXPECT_FALSE(stands_still(*bench));
    bench->flight.on = false;
    bench->session.fly(bench->session.culling_view());
    EXPECT_FALSE(stands_still(*bench));
    bench->session.land();
    EXPECT_TRUE(stands_still(*bench));
    for (bool Flight<2>::*moving : {&Flight<2>::recording, &Flight<2>::replaying}) {
        bench->flight.*moving = true;
        EXPECT_FALSE(stands_still(*bench));
        bench->flight.*moving = false;
    }
}

TEST_F(TradeOffOf, SaysWhatEachDotIsAndAClickSetsIt) {
    finish();
    const auto rows = trade_off_rows(*bench);
    std::size_t dots = 0;
    for (const Row& row : rows) {
        if (!row.command.starts_with("trade-off ") || row.command == "trade-off restart") continue;
        const TradeOffDot& dot = study().dots()[dots++];
        run(row.command);
        EXPECT_EQ(session().settings().method, study().task().variants[dot.variant].text);
        EXPECT_EQ(session().settings().budget, dot.budget);
        EXPECT_TRUE(is_current(*bench, dot));
        update_trade_off(*bench);
        EXPECT_TRUE(study().finished()) << row.command << " made it begin anew";
        const auto again = trade_off_rows(*bench);
        EXPECT_EQ(std::count_if(again.begin(), again.end(), [](const Row& r) { return r.text.ends_with("(now)"); }), 1);
        if (dots == 14) break;  // what is asked for beside the usual ones changes with the session
    }
    EXPECT_EQ(dots, 14u);
    run("undo");
    EXPECT_EQ(session().settings().method, "view") << "one click is one entry of the history";
}

TEST_F(TradeOffOf, AnErrorStopsItAndIsItsWord) {
    Random random(64);
    Start3 start = random_start_3d(random);
    Workbench<3> solid{Session<3>(start.scene, start.view, start.settings)};
    solid.graphics.draw_ids = [](const auto&...) -> std::vector<IdImage> { throw WorkError("OpenGL is lost"); };
    solid.say = [](const std::string&) {};
    EXPECT_FALSE(advance_trade_off(solid, 1000));
    EXPECT_TRUE(solid.trade_off.stopped);
    EXPECT_NE(solid.trade_off.word.find("OpenGL"), std::string::npos) << solid.trade_off.word;
    EXPECT_THROW(run_commands(solid, "trade-off finish"), WorkError);
}

TEST_F(TradeOffOf, PlotHoldsEveryDotAndTheNearestIsHit) {
    run("method layers; budget 1");
    finish();
    const Area area{10, 20, 300, 200};
    for (const char* shown : {"trade-off wrong", "trade-off coverage"}) {
        run(shown);
        const TradeOffPlot plot = trade_off_plot(*bench, area);
        ASSERT_EQ(plot.dots.size(), study().dots().size());
        EXPECT_GE(plot.times.size(), 2u);
        EXPECT_GE(plot.shares.size(), 3u);
        for (const TradeOffPlot::Dot& a : plot.dots) {
            EXPECT_TRUE(area.contains(a.at)) << a.at.x << " " << a.at.y;
            for (const TradeOffPlot::Dot& b : plot.dots) {
                const auto &p = study().dots()[a.index], &q = study().dots()[b.index];
                if (study().value(p, M::total_ms) < study().value(q, M::total_ms)) {
                    EXPECT_LE(a.at.x, b.at.x);
                }
                const M m = bench->trade_off.shown;
                if (study().value(p, m) < study().value(q, m)) {
                    EXPECT_GE(a.at.y, b.at.y) << "more is up";
                }
            }
            const TradeOffPlot::Dot* const hit = dot_at(plot, a.at, 9);
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->at.x, a.at.x);
            EXPECT_EQ(hit->at.y, a.at.y);
        }
        for (const auto* ticks : {&plot.times, &plot.shares}) {
            EXPECT_LE(ticks->size(), 14u);
            for (const TradeOffPlot::Tick& tick : *ticks) EXPECT_FALSE(tick.text.empty());
        }
        for (std::size_t i = 1; i < plot.dots.size(); ++i) {
            const auto &a = study().dots()[plot.dots[i - 1].index], &b = study().dots()[plot.dots[i].index];
            const std::size_t all = session().scene().primitives.size();
            EXPECT_LE(a.variant, b.variant);
            if (a.variant == b.variant) {
                EXPECT_LE(a.budget.primitives(all), b.budget.primitives(all)) << "a line goes back and forth";
            }
        }
        EXPECT_FALSE(dot_at(plot, {-500, -500}, 9));
    }
}

TEST_F(EachCommand, trade_off) {
    run("trade-off published 5%");
    EXPECT_EQ(session().settings().budget, (Budget{Budget::Kind::share, 0.05}));
    run("trade-off centroid unlimited");
    EXPECT_EQ(session().settings().method, "centroid");
    EXPECT_THROW(run("trade-off nothing 5%"), InputError);
    EXPECT_THROW(run("trade-off layers"), InputError);
    EXPECT_THROW(run("trade-off layers much"), InputError);
    EXPECT_EQ(session().settings().method, "centroid");
    run("trade-off coverage");
    EXPECT_EQ(bench->trade_off.shown, Measure::coverage);
    run("trade-off stop");
    EXPECT_TRUE(bench->trade_off.stopped);
    run("trade-off finish");
    EXPECT_TRUE(bench->trade_off.study.finished());
}

}  // namespace
}  // namespace sightline
