// What `auto` measures, remembers, and says.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/auto_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/measure/recommend.h"
#include "shell/desk/open_scene.h"
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
    const AutoChoice some_{"layers on_reenqueue=min", "tree", "5%", 3.625, 0.0005, false, "2026-11-29"};
};

TEST_F(AutoChoiceTest, IsSaidInOneLine) {
    EXPECT_EQ(auto_text(some_),
              "auto: layers on_reenqueue=min on tree cells at 5%, 3.62 ms, 0.05 % of the pixels wrong; measured "
              "2026-11-29");
    EXPECT_EQ(auto_text({"hzb", "delaunay", "unlimited", 3.6, 0, false, "2026-11-29"}),
              "auto: hzb, 3.6 ms, nothing wrong; measured 2026-11-29");
    EXPECT_EQ(auto_text({"view", "delaunay", "unlimited", 2, 0, true, "2026-11-29"}),
              "auto: view, 2 ms, nothing wrong, since nearly all that is in view is visible; measured 2026-11-29");
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

TEST_F(AutoChoiceTest, IsTakenAndOverridden) {
    Workbench<2> bench = bench_on("rooms");
    bench.auto_file = file();
    std::vector<std::string> said;
    bench.say = [&](const std::string& line) { said.push_back(line); };
    keep_auto(file(), auto_key(bench), {"layers", "tree", "2%", 1, 0.25, false, "2001-02-03"});
    choose_auto(bench, false);
    EXPECT_EQ(bench.session.settings().method, "layers");
    EXPECT_EQ(bench.session.settings().tessellation, Tessellation::tree);
    EXPECT_EQ(budget_text(bench.session.settings().budget), "2%");
    EXPECT_EQ(said.back(), "auto: layers on tree cells at 2%, 1 ms, 25 % of the pixels wrong; measured 2001-02-03");
    choose_auto<2>(bench, false, [](Settings& s) { s.budget = parse_budget("7"); });
    EXPECT_EQ(budget_text(bench.session.settings().budget), "7");
    EXPECT_EQ(bench.session.settings().method, "layers");
    // What another program remembered under a method that is not there is measured again.
    keep_auto(file(), auto_key(bench), {"magic", "tree", "2%", 1, 0.25, false, "2001-02-03"});
    choose_auto(bench, false);
    EXPECT_NE(said.back().find("measured 20"), std::string::npos);
    EXPECT_EQ(said.back().find("2001"), std::string::npos);
    EXPECT_NE(recall_auto(file(), auto_key(bench))->method, "magic");
}

TEST_F(AutoChoiceTest, IsOneOfTheOffersAndRightEnough) {
    const Workbench<2> rooms = bench_on("rooms");
    const AutoChoice choice = measure_auto(rooms);
    EXPECT_FALSE(choice.all_visible) << "walls hide most";
    EXPECT_LE(choice.wrong, unseen_wrong) << "conservative methods are among them";
    EXPECT_GT(choice.ms, 0);
    // Nothing hides anything: two segments beside each other.
    auto scene = std::make_shared<Scene<2>>();
    scene->primitives = {{Vec<2>(2, 1), Vec<2>(2, .5)}, {Vec<2>(2, -.5), Vec<2>(2, -1)}};
    const Workbench<2> open{Session<2>(scene, {{0, 0}, {1, 0}, 90}, {})};
    const AutoChoice of_open = measure_auto(open);
    EXPECT_TRUE(of_open.all_visible);
    EXPECT_EQ(of_open.method, "view");
    EXPECT_EQ(of_open.budget, "unlimited");
    EXPECT_THROW(measure_auto(open, 0), WorkError) << "no time";
}

TEST_F(EachCommand, auto) {
    bench->auto_file = folder / "auto.json";
    run("auto");
    ASSERT_EQ(said.size(), 2u) << "the run that was made again, and what was chosen";
    EXPECT_TRUE(said.back().starts_with("auto: ")) << said.back();
    const std::optional<AutoChoice> kept = recall_auto(bench->auto_file, auto_key(*bench));
    ASSERT_TRUE(kept);
    EXPECT_EQ(said.back(), auto_text(*kept));
    AutoChoice known = *kept;
    known.date = "2001-02-03";
    keep_auto(bench->auto_file, auto_key(*bench), known);
    run("auto");
    EXPECT_NE(said.back().find("2001-02-03"), std::string::npos);
    run("auto again");
    EXPECT_EQ(said.back().find("2001-02-03"), std::string::npos);
    EXPECT_THROW(run("auto now"), InputError);
}

}  // namespace
}  // namespace sightline
