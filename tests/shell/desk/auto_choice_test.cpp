// What `auto` measures, remembers, and says.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/auto_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/measure/recommend.h"
#include "core/session/state_file.h"
#include "shell/desk/change.h"
#include "shell/desk/open.h"
#include "shell/desk/undo.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

class AutoChoiceTest : public ::testing::Test {
protected:
    AutoChoiceTest() { std::filesystem::remove_all(folder_); }
    ~AutoChoiceTest() override { std::filesystem::remove_all(folder_); }

    static Workbench<2> bench_on(const std::string& scene) {
        return {open_scene(scene, start_settings(scene), method_table<2>(), [](const std::string&) {})};
    }
    std::filesystem::path file() const { return folder_ / "cache" / "auto.json"; }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("sightline-auto-" + std::to_string(getpid()));
    const AutoChoice some_{"layers on_reenqueue=min", "tree", "5%",        3.625, 0.0005, 4, 0,
                           "tri at 10%, 3.7 ms",      "",     "2026-11-29"};
};

TEST_F(AutoChoiceTest, IsSaidInOneLine) {
    EXPECT_EQ(auto_text(some_),
              "auto: layers on_reenqueue=min on tree cells at 5%, 3.62 ms, 0.05 % of the pixels wrong, over 4 frames; "
              "a close call with tri at 10%, 3.7 ms; measured 2026-11-29");
    EXPECT_EQ(auto_text({"hzb", "delaunay", "unlimited", 3.6, 0, 4, 0, "", "", "2026-11-29"}),
              "auto: hzb, 3.6 ms, nothing wrong, over 4 frames; measured 2026-11-29");
    EXPECT_EQ(auto_text({"view", "delaunay", "unlimited", 2, 0, 1, 0.001, "", "nearly all that is in view is visible",
                         "2026-11-29"}),
              "auto: view, 2 ms with drawing as 1 ms per 1000, nothing wrong, in one frame, since nearly all that is "
              "in view is visible; measured 2026-11-29");
}

TEST_F(AutoChoiceTest, IsRememberedByItsKey) {
    EXPECT_EQ(recall_auto(file(), "a"), std::nullopt);
    keep_auto(file(), "a", some_);
    AutoChoice other = some_;
    other.method = "hzb";
    keep_auto(file(), "b", other);
    EXPECT_EQ(recall_auto(file(), "a"), some_);
    EXPECT_EQ(recall_auto(file(), "b"), other);
    EXPECT_EQ(recall_auto(file(), "c"), std::nullopt);
    other.ms = 1;
    keep_auto(file(), "a", other);
    EXPECT_EQ(recall_auto(file(), "a"), other);
    for (int i = 0; i < 250; ++i) keep_auto(file(), std::to_string(i), some_);
    EXPECT_EQ(recall_auto(file(), "249"), some_);
    EXPECT_EQ(recall_auto(file(), "a"), std::nullopt) << "the oldest go";
    EXPECT_NO_THROW(keep_auto({}, "a", some_));
}

TEST_F(AutoChoiceTest, OfADamagedFileIsNothing) {
    std::filesystem::create_directories(file().parent_path());
    keep_auto(file(), "a", some_);
    const std::string good = read_file(file());
    for (std::size_t end = 0; end + 2 < good.size(); end += 7) {
        write_file(file(), good.substr(0, end));
        EXPECT_EQ(recall_auto(file(), "a"), std::nullopt) << end;
    }
    for (const auto& [from, to] : {std::pair{"\"5%\"", "\"much\""},
                                   {"\"5%\"", "7"},
                                   {"\"tree\"", "\"moss\""},
                                   {"3.625", "\"x\""},
                                   {"sightline-auto", "other"}}) {
        std::string text = good;
        text.replace(text.find(from), std::string(from).size(), to);
        write_file(file(), text);
        EXPECT_EQ(recall_auto(file(), "a"), std::nullopt) << to;
    }
    keep_auto(file(), "a", some_);
    EXPECT_EQ(recall_auto(file(), "a"), some_) << "written anew";
}

TEST_F(AutoChoiceTest, LiesWhereCachesDo) {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    const std::string before = cache ? cache : "";
    setenv("XDG_CACHE_HOME", "/tmp/somewhere", 1);
    EXPECT_EQ(auto_file(), "/tmp/somewhere/sightline/auto.json");
    setenv("XDG_CACHE_HOME", "relative", 1);
    if (std::getenv("HOME")) {
        EXPECT_TRUE(auto_file().string().ends_with(".cache/sightline/auto.json"));
    }
    if (cache)
        setenv("XDG_CACHE_HOME", before.c_str(), 1);
    else
        unsetenv("XDG_CACHE_HOME");
}

TEST_F(AutoChoiceTest, IsTaken) {
    Workbench<2> bench = bench_on("rooms");
    bench.auto_file = file();
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    keep_auto(file(), auto_key(bench), {"layers", "tree", "2%", 1, 0.25, 4, 0, "", "", "2001-02-03"});
    choose_auto(bench, false, bench.session.settings());
    EXPECT_EQ(bench.session.settings().method, "layers");
    EXPECT_EQ(bench.session.settings().tessellation, Tessellation::tree);
    EXPECT_EQ(budget_text(bench.session.settings().budget), "2%");
    EXPECT_EQ(bench.session.settings().automatic, Switch::on);
    EXPECT_EQ(said.back(),
              "auto: layers on tree cells at 2%, 1 ms, 25 % of the pixels wrong, over 4 frames; measured 2001-02-03");
    // What another program remembered under a method that is not there is measured again.
    keep_auto(file(), auto_key(bench), {"magic", "tree", "2%", 1, 0.25, 4, 0, "", "", "2001-02-03"});
    choose_auto(bench, false, bench.session.settings());
    EXPECT_NE(said.back().find("measured 20"), std::string::npos);
    EXPECT_EQ(said.back().find("2001"), std::string::npos);
    EXPECT_NE(recall_auto(file(), auto_key(bench))->method, "magic");
}

TEST_F(AutoChoiceTest, KeepsABudgetThatIsAskedForAndCutsNothingShort) {
    for (const char* scene : {"rooms", "streets"})
        for (const char* text : {"1%", "40", "unlimited"}) {
            Workbench<2> bench = bench_on(scene);
            bench.auto_file = file();
            bench.say = [](const std::string&) {};
            const Budget budget = parse_budget(text);
            choose_auto(bench, false, bench.session.settings(), budget);
            EXPECT_EQ(bench.session.settings().budget, budget);
            EXPECT_EQ(recall_auto(file(), auto_key(bench)), std::nullopt) << "for this budget only";
            bench.session.run();
            const std::uint32_t most = budget.primitives(bench.session.scene().primitives.size());
            EXPECT_TRUE(bench.session.method().budgeted || bench.session.counters().drawn() <= most) << text;
            EXPECT_TRUE(bench.session.method().budgeted ||
                        bench.session.guarantee().find("cut short") == std::string::npos)
                << scene << " " << text << " " << bench.session.method().id;
        }
}

TEST_F(AutoChoiceTest, IsTakenWhereItCannotBeRemembered) {
    Workbench<2> bench = bench_on("bottleneck");
    std::filesystem::create_directories(folder_);
    write_file(folder_ / "file", "no folder");
    bench.auto_file = folder_ / "file" / "sightline" / "auto.json";
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    choose_auto(bench, false, bench.session.settings());
    EXPECT_EQ(bench.session.settings().automatic, Switch::on);
    ASSERT_GE(said.size(), 2u);
    EXPECT_TRUE(said.front().starts_with("warning: what auto found is not remembered: cannot make the folder "))
        << said.front();
    EXPECT_TRUE(said.back().starts_with("auto: ")) << said.back();
}

TEST_F(AutoChoiceTest, IsASettingThatGoesOffByHand) {
    Workbench<2> bench = bench_on("rooms");
    bench.auto_file = file();
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    keep_auto(file(), auto_key(bench), {"layers", "tree", "2%", 1, 0.25, 4, 0, "", "", "2001-02-03"});
    const auto by_hand = [&](const std::string& assignment) {
        said.clear();
        Settings settings = bench.session.settings();
        apply_setting(settings, assignment);
        change_by_hand(bench, settings);
        return bench.session.settings().automatic == Switch::on;
    };
    for (const auto& [assignment, what] : {std::pair{"method=flux", "the method was"},
                                           {"on_reenqueue=min", "the method was"},
                                           {"budget=7", "the budget was"},
                                           {"error_bound=0.1", "the cells were"},
                                           {"tessellation=kd", "the cells were"}}) {
        const std::string error_bound = "error_bound=" + number_text(bench_on("rooms").session.settings().error_bound);
        by_hand(error_bound);
        ASSERT_TRUE(by_hand("auto=on"));
        EXPECT_EQ(bench.session.settings().method, "layers");
        EXPECT_EQ(bench.session.settings().tessellation, Tessellation::tree);
        EXPECT_TRUE(said.back().starts_with("auto: layers")) << said.back();
        EXPECT_TRUE(by_hand("label=order")) << "only the picture";
        EXPECT_TRUE(by_hand("reference_size=512"));
        EXPECT_TRUE(by_hand("reference_size=auto"));
        EXPECT_FALSE(by_hand(assignment)) << assignment;
        EXPECT_TRUE(said.back().ends_with("auto is off: " + std::string(what) + " set by hand")) << said.back();
        EXPECT_EQ(setting_row(std::string(assignment).substr(0, std::string(assignment).find('=')))
                      .get(bench.session.settings()),
                  std::string(assignment).substr(std::string(assignment).find('=') + 1));
        undo(bench);
        EXPECT_EQ(bench.session.settings().automatic, Switch::on) << "with what was set by hand it is undone";
        EXPECT_EQ(bench.session.settings().method, "layers");
        EXPECT_FALSE(by_hand("auto=off"));
        EXPECT_EQ(bench.session.settings().method, "layers") << "what was recommended stays";
    }
    Settings both = bench.session.settings();
    both.budget = parse_budget("9");
    both.method = "flux";
    EXPECT_EQ(left_auto(bench.session.settings(), both), "auto is off: the method and the budget were set by hand");
    EXPECT_EQ(left_auto(both, both), "");
}

TEST_F(AutoChoiceTest, GivesWayToThePresetOfAMethod) {
    Workbench<2> bench = bench_on("rooms");
    bench.auto_file = file();
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    keep_auto(file(), auto_key(bench), {"tri-z", "delaunay", "2%", 1, 0.25, 4, 0, "", "", "2001-02-03"});
    for (const Preset& preset : presets()) {
        choose_auto(bench, false, bench.session.settings());
        ASSERT_EQ(bench.session.settings().method, "tri-z");
        run_commands(bench, "preset " + std::string(preset.id));
        EXPECT_EQ(bench.session.settings().method, preset.method.empty() ? "tri-z" : preset.method) << preset.id;
        EXPECT_EQ(said.back().ends_with("auto is off: the method was set by hand"), !preset.method.empty());
    }
    run_commands(bench, "method layers; preset paper-3d");
    EXPECT_EQ(bench.session.settings().method, "layers") << "chosen by hand";
}

TEST_F(AutoChoiceTest, FollowsWhenASceneIsOpenedAndStaysAsAStateHasIt) {
    Workbench<2> bench = bench_on("rooms");
    bench.auto_file = file();
    keep_auto(file(), auto_key(bench), {"layers", "tree", "2%", 1, 0.25, 4, 0, "", "", "2001-02-03"});
    keep_auto(file(), auto_key(bench_on("streets")),
              {"view", "delaunay", "unlimited", 1, 0, 1, 0, "", "nothing is in view", "2001-02-04"});
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    open(bench, "streets");
    EXPECT_NE(bench.session.settings().method, "view") << "auto is off";
    open(bench, "rooms");
    choose_auto(bench, false, bench.session.settings());
    open(bench, "streets");
    EXPECT_EQ(bench.session.settings().method, "view");
    EXPECT_EQ(bench.session.settings().automatic, Switch::on);
    EXPECT_NE(said.back().find(", since nothing is in view;"), std::string::npos) << said.back();
    // A state reopens as it was, whatever is recommended now.
    open(bench, "rooms");
    const std::string state = state_json(bench.session, {});
    keep_auto(file(), auto_key(bench), {"centroid", "delaunay", "5%", 1, 0.25, 4, 0, "", "", "2001-02-05"});
    open_state_text(bench, state, "kept.json");
    EXPECT_EQ(bench.session.settings().method, "layers");
    EXPECT_EQ(bench.session.settings().automatic, Switch::on);
    open(bench, "rooms");
    EXPECT_EQ(bench.session.settings().method, "centroid") << "and the next scene is followed again";
}

TEST_F(AutoChoiceTest, ComesFromWhatEnginesDoAndFromOrders) {
    const Workbench<2> bench = bench_on("rooms");
    const auto ids = [&](bool cells_only) {
        std::vector<std::string_view> found;
        for (const Variant<2>& variant : auto_methods(bench, cells_only)) found.push_back(variant.method.id);
        return found;
    };
    const auto has = [](const std::vector<std::string_view>& all, std::string_view id) {
        return std::count(all.begin(), all.end(), id) == 1;
    };
    const auto all = ids(false), of_cells = ids(true);
    for (const char* id : {"view", "boxes", "hzb", "hom", "two-pass", "coorg-teller", "tri-z"}) {
        EXPECT_TRUE(has(all, id)) << id;
        EXPECT_FALSE(has(of_cells, id)) << id;
        EXPECT_LT(std::find(all.begin(), all.end(), id), std::find(all.begin(), all.end(), "published")) << id;
    }
    for (const char* id : {"published", "layers", "flux", "tri", "extinction"}) {
        EXPECT_TRUE(has(all, id)) << id;
        EXPECT_TRUE(has(of_cells, id)) << id;
    }
    for (const char* id : {"perfect", "formula", "levels"}) EXPECT_FALSE(has(all, id)) << id;
}

TEST_F(AutoChoiceTest, IsOneOfTheOffersAndRightEnough) {
    const Workbench<2> rooms = bench_on("rooms");
    const AutoChoice choice = measure_auto(rooms);
    EXPECT_EQ(choice.since, "") << "walls hide most";
    EXPECT_LE(choice.wrong, unseen_wrong) << "conservative methods are among them";
    EXPECT_GT(choice.ms, 0);
    EXPECT_EQ(choice.guessed_ms, 0.001) << "segments cost nothing to draw";
    EXPECT_EQ(choice.frames, 1u) << "no path: the view at hand";
    // Nothing hides anything: two segments beside each other.
    auto scene = std::make_shared<Scene<2>>();
    scene->primitives = {{Vec<2>(2, 1), Vec<2>(2, .5)}, {Vec<2>(2, -.5), Vec<2>(2, -1)}};
    const Workbench<2> open{Session<2>(scene, {{0, 0}, {1, 0}, 90}, {})};
    const AutoChoice of_open = measure_auto(open);
    EXPECT_EQ(of_open.since, "nearly all that is in view is visible");
    EXPECT_EQ(of_open.method, "view");
    EXPECT_EQ(of_open.budget, "unlimited");
    EXPECT_THROW(measure_auto(open, 0), WorkError) << "no time";
    // The eye looks away from them, or there are none.
    const Workbench<2> away{Session<2>(scene, {{0, 0}, {-1, 0}, 90}, {})};
    EXPECT_EQ(measure_auto(away).method, "view");
    EXPECT_EQ(measure_auto(away).since, "nothing is in view");
    const Workbench<2> empty{Session<2>(std::make_shared<Scene<2>>(), {{0, 0}, {1, 0}, 90}, {})};
    EXPECT_EQ(measure_auto(empty).method, "view");
    EXPECT_EQ(measure_auto(empty).since, "nothing is in view");
}

TEST_F(EachCommand, auto) {
    bench->auto_file = folder / "auto.json";
    run("auto");
    ASSERT_EQ(said.size(), 1u) << "one line, which the status line can show";
    EXPECT_TRUE(said.back().starts_with("auto: ")) << said.back();
    const std::optional<AutoChoice> kept = recall_auto(bench->auto_file, auto_key(*bench));
    ASSERT_TRUE(kept);
    EXPECT_EQ(said.back(), auto_text(*kept));
    AutoChoice known = *kept;
    known.date = "2001-02-03";
    keep_auto(bench->auto_file, auto_key(*bench), known);
    run("auto");
    EXPECT_NE(said.back().find("2001-02-03"), std::string::npos);
    EXPECT_EQ(session().settings().automatic, Switch::on);
    run("budget 40");
    EXPECT_EQ(session().settings().automatic, Switch::off);
    run("set auto=on");
    EXPECT_NE(said.back().find("2001-02-03"), std::string::npos);
    run("auto again");
    EXPECT_EQ(said.back().find("2001-02-03"), std::string::npos);
    test::expect_input_error([&] { run("auto off"); },
                             "command 'auto off': write again, or nothing; set auto=off switches it off");
    run("set auto=off");
    EXPECT_EQ(session().settings().automatic, Switch::off);
}

}  // namespace
}  // namespace sightline
