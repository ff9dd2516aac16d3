// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/make/catalogue.h"
#include "shell/desk/change.h"
#include "shell/desk/compare.h"
#include "shell/desk/edit.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"
#include "shell/desk/open.h"
#include "shell/desk/play.h"
#include "shell/desk/undo.h"
#include "shell/export/export.h"
#include "shell/panels/panel_table.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

/// Where the right side has to be.
std::uint64_t followed(const Workbench<2>& bench) {
    Session<2> other(bench.other->session.shared_scene(), bench.other->session.culling_view(),
                     bench.other->session.settings());
    other.run();
    follow(bench.session, other, bench.other->align);
    return other.hash();
}

TEST(BenchComparison, GoesAlongWithEveryMoveAndChange) {
    Random random(101);
    int moves = 0;
    for (int i = 0; i < 60; ++i) {
        test::Bench on(test::random_start(random, 40).session());
        Workbench<2>& bench = on.bench;
        if (random.below(2)) test::record_ahead(bench);
        compare_settings(bench, test::random_start(random).settings, "other");
        align_with(bench, random.below(2) ? Align::step : Align::rendered);
        for (int k = 0; k < 25; ++k) {
            const Settings right = bench.other->session.settings();
            try {
                switch (random.below(11)) {
                    case 0:
                        step_forward(bench, 1 + static_cast<std::uint32_t>(random.below(9)));
                        break;
                    case 1:
                        step_back(bench, 1 + static_cast<std::uint32_t>(random.below(9)));
                        break;
                    case 2:
                        run_to_end(bench);
                        break;
                    case 3:
                        change_view(bench, test::random_view(random), "drag");
                        break;
                    case 4:
                        change_settings(bench, test::random_start(random).settings);
                        break;
                    case 5:
                        undo(bench);
                        break;
                    case 6:
                        redo(bench);
                        break;
                    case 7:
                        add_segment(bench,
                                    {Vec<2>(random.unit(), random.unit()), Vec<2>(random.unit(), random.unit())});
                        break;
                    case 8:
                        delete_segment(bench, static_cast<std::uint32_t>(random.below(
                                                  std::max<std::size_t>(1, bench.session.scene().primitives.size()))));
                        break;
                    case 9:
                        bench.session.frozen() ? bench.session.unfreeze() : bench.session.freeze();
                        moved(bench);
                        break;
                    case 10:
                        play(bench);
                        bench.transport.steps_per_second = 16;
                        advance_clock(bench, 0.25);
                        pause(bench);
                        break;
                }
            } catch (const InputError&) {
            } catch (const std::out_of_range&) {
            }
            const Session<2>&left = bench.session, &other = bench.other->session;
            ASSERT_EQ(other.settings(), right) << "changes of settings are those of the left side";
            ASSERT_EQ(other.shared_scene(), left.shared_scene());
            ASSERT_EQ(other.culling_view(), left.culling_view());
            ASSERT_EQ(other.frozen(), left.frozen());
            ASSERT_EQ(other.display_view(), left.display_view());
            ASSERT_EQ(other.hash(), followed(bench));
            if (bench.record_ahead) {
                ASSERT_EQ(other.recorded(), at_the_end(other).recorded());
            }
            ++moves;
        }
    }
    EXPECT_EQ(moves, 60 * 25);
}

TEST(BenchComparison, AnotherSceneKeepsItsOwnPlace) {
    Random random(102);
    test::Bench on(test::random_cell_start(random, 40).session());
    Workbench<2>& bench = on.bench;
    const test::Start start = test::random_cell_start(random, 40);
    compare_with(bench, start.session(), "elsewhere");
    change_view(bench, test::random_view(random));
    add_segment(bench, {Vec<2>(0.1, 0.2), Vec<2>(0.3, 0.7)});
    EXPECT_EQ(bench.other->session.shared_scene(), start.scene);
    EXPECT_EQ(bench.other->session.culling_view(), start.view);
    // The same scene read twice is one scene.
    const auto twin = std::make_shared<const Scene<2>>(bench.session.scene());
    compare_with(bench, Session<2>(twin, start.view, start.settings), "twin");
    EXPECT_EQ(bench.other->session.shared_scene(), bench.session.shared_scene());
    EXPECT_EQ(bench.other->session.culling_view(), start.view) << "until the left one looks elsewhere";
    const ViewSpec<2> view = test::random_view(random);
    change_view(bench, view);
    EXPECT_EQ(bench.other->session.culling_view(), view);
}

TEST(BenchComparison, FindsTheFirstDifferenceOfTheWholeRuns) {
    Random random(103);
    int different = 0, same = 0;
    for (int i = 0; i < 80; ++i) {
        test::Bench on(test::random_start(random, 30).session());
        Workbench<2>& bench = on.bench;
        if (random.below(2)) test::record_ahead(bench);
        go_to_step(bench, 2);
        Settings settings = bench.session.settings();
        if (i % 4 > 0) settings.jitter = settings.jitter > 0 ? 0 : 0.25;
        compare_settings(bench, settings, "jitter");
        if (random.below(2)) test::record_ahead(bench);  // a window opened on both
        const auto expected = first_difference(at_the_end(bench.session), at_the_end(bench.other->session));
        const std::uint32_t before = bench.session.position();
        go_to_difference(bench);
        EXPECT_EQ(bench.session.position(), expected ? std::min(*expected, whole_run(bench)) : before);
        EXPECT_EQ(first_difference(bench).step, expected.value_or(none));
        (expected ? different : same) += 1;
        // What was found is forgotten with the runs it was found in.
        change_view(bench, test::random_view(random));
        EXPECT_EQ(first_difference(bench).step,
                  first_difference(at_the_end(bench.session), at_the_end(bench.other->session)).value_or(none));
        compare_settings(bench, bench.session.settings(), "same");
        EXPECT_EQ(first_difference(bench).step, none);
    }
    EXPECT_GT(different, 10);
    EXPECT_GT(same, 15);
}

class BenchComparisonFiles : public ::testing::Test {
protected:
    BenchComparisonFiles() {
        std::filesystem::create_directories(folder);
        const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
        on = std::make_unique<test::Bench>(
            Session<2>(std::make_shared<const Scene<2>>(make_scene(row)), row.view, start_settings("bottleneck")));
        Settings settings = on->bench.session.settings();
        settings.method = "centroid";
        compare_settings(on->bench, settings, "centroid");
        go_to_step(on->bench, 4);
    }
    ~BenchComparisonFiles() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("sightline-comparison-" + std::to_string(getpid()));
    std::unique_ptr<test::Bench> on;
};

TEST_F(BenchComparisonFiles, AStateFileBringsBothBack) {
    align_with(on->bench, Align::rendered);
    const std::string text = bench_state(on->bench);
    Random random(104);
    test::Bench again(test::random_start(random).session());
    again.bench.record_ahead = true;
    open_state_text(again.bench, text, "text");
    ASSERT_TRUE(again.bench.other);
    EXPECT_EQ(again.bench.session.hash(), on->bench.session.hash());
    EXPECT_EQ(again.bench.other->session.hash(), on->bench.other->session.hash());
    EXPECT_EQ(again.bench.other->session.settings(), on->bench.other->session.settings());
    EXPECT_EQ(again.bench.other->align, Align::rendered);
    EXPECT_EQ(bench_state(again.bench), text);
    compare_off(on->bench);
    open_state_text(again.bench, bench_state(on->bench), "text");
    EXPECT_FALSE(again.bench.other);
}

TEST_F(BenchComparisonFiles, AShotShowsBothSides) {
    const auto shot = [&](const char* name) {
        write_shot(on->bench, (folder / name).string());
        return read_file(folder / name);
    };
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    const std::string pair = shot("pair.svg");
    const auto result = [](const Session<2>& session) {
        return std::to_string(session.counters().rendered_count) + " drawn · " +
               std::to_string(session.visible_rendered()) + " of " + std::to_string(session.reference().count) +
               " visible";
    };
    EXPECT_EQ(side_head(on->bench.session, "PLP").text(), "PLP · " + result(on->bench.session));
    Settings settings = on->bench.session.settings();
    settings.show_visibility = Switch::off;
    Session<2> concealed = on->bench.session;
    concealed.change(settings);
    EXPECT_EQ(side_head(concealed, "PLP").text(),
              "PLP · " + std::to_string(concealed.counters().rendered_count) + " drawn");
    EXPECT_TRUE(has(pair, "(a) PLP · ") && has(pair, "(b) centroid order")) << pair.substr(0, 3000);
    on->bench.figure.panels = {"step 3", "step 9"};
    const std::string four = shot("four.svg");
    Session<2> other = on->bench.other->session;
    other.seek(9);  // its budget may end before
    const std::string last = "(d) step " + std::to_string(other.position()) + ", centroid";
    for (const char* title : {"(a) step 3, PLP · ", "(b) step 3, centroid", "(c) step 9, PLP · ", last.c_str()})
        EXPECT_TRUE(has(four, title)) << title;
    EXPECT_EQ(on->bench.session.position(), 4u);
    EXPECT_EQ(on->bench.other->session.position(), 4u);
    compare_off(on->bench);
    on->bench.figure.panels.clear();
    EXPECT_FALSE(has(shot("one.svg"), "centroid"));
}

TEST_F(BenchComparisonFiles, SwappingTwiceIsNothing) {
    const std::string before = bench_state(on->bench);
    on->bench.session.breakpoints = {{"step:3", true}};
    swap_sides(on->bench);
    EXPECT_EQ(on->bench.session.settings().method, "centroid");
    EXPECT_EQ(on->bench.session.breakpoints.size(), 1u);
    EXPECT_EQ(side_titles(on->bench), (std::array<std::string, 2>{"centroid order", "PLP"}));
    swap_sides(on->bench);
    on->bench.session.breakpoints.clear();
    EXPECT_EQ(bench_state(on->bench), before);
}

TEST_F(BenchComparisonFiles, ThePanelTellsWhatIsDifferent) {
    const auto text = [&] {
        std::string all;
        for (const Row& row : compare_rows(on->bench)) all += row.text + "\n";
        return all;
    };
    const std::string said = text();
    EXPECT_EQ(said.find("PLP | centroid order\n"), 0u) << said;
    EXPECT_NE(said.find("inversions: " + std::to_string(on->bench.session.inversions().size()) + " | –\n"),
              std::string::npos)
        << "a method without a front has none: " << said;
    EXPECT_NE(said.find("aligned by step: both have made 4 steps\n"), std::string::npos) << said;
    EXPECT_NE(said.find("step: 4 of "), std::string::npos) << said;
    EXPECT_NE(said.find(first_difference(on->bench).sentence), std::string::npos) << said;
    compare_settings(on->bench, on->bench.session.settings(), "same");
    EXPECT_NE(text().find("left | same\n"), std::string::npos) << text();
    EXPECT_NE(text().find("Both agree to the end"), std::string::npos) << text();
    compare_off(on->bench);
    EXPECT_EQ(compare_rows(on->bench).size(), 1u);
}

}  // namespace
}  // namespace sightline
