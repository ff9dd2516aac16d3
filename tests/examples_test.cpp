// Everything in examples/ and every command in the documents is run: what a reader copies works.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <span>
#include <sstream>

#include "core/base/file.h"
#include "core/scene/read/load.h"
#include "core/session/state_file.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

const fs::path source = SIGHTLINE_SOURCE_DIR;
const std::string viewer = SIGHTLINE_VIEWER2D;

/// An empty folder with the examples in it, as a checkout has them, and an out/ to write to.
class Examples : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string(test->name()) + "-" + std::to_string(getpid());
        std::replace(name.begin(), name.end(), '/', '_');
        folder_ = fs::path(testing::TempDir()) / ("sightline_examples_" + name);
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "out");
        fs::create_directory_symlink(source / "examples", folder_ / "examples");
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Runs a shell command in the folder; returns its exit status and keeps what it said.
    int run(const std::string& command) {
        const std::string log = (folder_ / "log").string();
        const int status =
            std::system(("cd '" + folder_.string() + "' && { " + command + "\n} >'" + log + "' 2>&1").c_str());
        said_ = read_file(log);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    fs::path folder_;
    std::string said_;
};

std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension = "") {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void expect_figure(const fs::path& file) {
    const std::string bytes = read_file(file.string());
    const std::string extension = file.extension().string();
    if (extension == ".png") {
        EXPECT_TRUE(bytes.starts_with("\x89PNG\r\n\x1a\n")) << file;
    }
    if (extension == ".pdf") {
        EXPECT_TRUE(bytes.starts_with("%PDF-")) << file;
    }
    if (extension == ".svg") {
        EXPECT_NE(bytes.find("<svg"), std::string::npos) << file;
        EXPECT_NE(bytes.find("</svg>"), std::string::npos) << file;
        EXPECT_NE(bytes.find("<text"), std::string::npos) << file << ": no text, or text as outlines";
    }
    EXPECT_TRUE(fs::exists(file.string() + ".json")) << file << " has no sidecar";
}

TEST_F(Examples, EverySceneLoadsAndSteps) {
    const auto scenes = files_in(source / "examples/scenes");
    ASSERT_GE(scenes.size(), 2u);
    for (const fs::path& file : scenes) {
        const auto scene = std::make_shared<const Scene<2>>(load_scene(file.string()));
        EXPECT_EQ(scene->dropped.total(), 0u) << file;
        EXPECT_TRUE(scene->warnings.empty()) << file;
        ASSERT_TRUE(scene->start_view) << file;
        Session<2> session(scene, *scene->start_view, Settings{});
        EXPECT_EQ(session.run(), Stop::front_empty) << file;
        EXPECT_GT(session.visible_rendered(), 0u) << file;
    }
}

TEST_F(Examples, CoordinatesOfALandSurveyAreRecentred) {
    const Scene<2> scene = load_scene((source / "examples/scenes/quarter.geojson").string());
    EXPECT_GT(scene.origin.x, 1.5e6);
    EXPECT_GT(scene.origin.y, 5e6);
    EXPECT_LT(bounds<2>(scene.primitives).longest_side(), 1000);
}

TEST_F(Examples, EveryStateFileOpensAsItWasSaved) {
    const auto states = files_in(source / "examples/states", ".json");
    ASSERT_GE(states.size(), 2u);
    for (const fs::path& file : states) {
        const OpenedState opened = open_state(read_file(file.string()), file.string());
        EXPECT_TRUE(opened.warnings.empty()) << file << ": " << opened.warnings.front();
        EXPECT_FALSE(opened.session.notes.empty()) << file;
        EXPECT_EQ(run(viewer + " --headless --state '" + file.string() + "' --shot out/state.svg"), 0) << said_;
        expect_figure(folder_ / "out/state.svg");
    }
}

template <int D>
void expect_same_state(const fs::path& file, const fs::path& again) {
    SCOPED_TRACE(file);
    ASSERT_TRUE(fs::exists(again)) << "it is not made by the script";
    const OpenedState<D> saved = open_state<D>(read_file(file.string()), file.string());
    const OpenedState<D> made = open_state<D>(read_file(again.string()), again.string());
    EXPECT_TRUE(saved.warnings.empty()) << saved.warnings.front();
    EXPECT_EQ(saved.session.hash(), made.session.hash());
    EXPECT_EQ(saved.session.settings(), made.session.settings());
    EXPECT_EQ(saved.session.position(), made.session.position());
    EXPECT_EQ(saved.session.selected_cell, made.session.selected_cell);
    EXPECT_EQ(saved.session.selected_primitive, made.session.selected_primitive);
    EXPECT_EQ(saved.session.notes.size(), made.session.notes.size());
    ASSERT_EQ(saved.other.has_value(), made.other.has_value());
    if (saved.other) {
        EXPECT_EQ(saved.other->hash(), made.other->hash());
    }
    EXPECT_EQ(saved.align, made.align);
}

/// A lesson's files open as they were saved, and are what their script makes.
TEST_F(Examples, EveryStateOfTheLessonIsWhatItsScriptMakes) {
    ASSERT_EQ(run("sh '" + (source / "examples/lesson/make.sh").string() + "' '" + viewer + "' out"), 0) << said_;
    const auto states = files_in(source / "examples/lesson", ".json");
    ASSERT_GE(states.size(), 10u);
    EXPECT_EQ(files_in(folder_ / "out", ".json").size(), states.size());
    const std::string page = read_file((source / "docs/teaching.md").string());
    for (const fs::path& file : states) {
        EXPECT_NE(page.find("--state examples/lesson/" + file.filename().string()), std::string::npos) << file;
        expect_same_state<2>(file, folder_ / "out" / file.filename());
    }
}

/// So do those of the figures of Coorg and Teller, each of which is on the page of figures.
TEST_F(Examples, EveryStateOfCoorgAndTellerIsWhatItsScriptMakes) {
    const fs::path states = source / "examples/states/coorg-teller";
    ASSERT_EQ(run("sh '" + (states / "make.sh").string() + "' '" + viewer + "' '" + SIGHTLINE_VIEWER3D + "' out"), 0)
        << said_;
    const auto files = files_in(states, ".json");
    ASSERT_GE(files.size(), 13u);
    EXPECT_EQ(files_in(folder_ / "out", ".json").size(), files.size());
    const std::string page = read_file((source / "docs/figures.md").string());
    for (const fs::path& file : files) {
        EXPECT_NE(page.find("--state examples/states/coorg-teller/" + file.filename().string()), std::string::npos)
            << file;
        const fs::path again = folder_ / "out" / file.filename();
        if (read_file(file.string()).find("\"dimension\": 3") == std::string::npos)
            expect_same_state<2>(file, again);
        else
            expect_same_state<3>(file, again);
    }
}

TEST_F(Examples, EveryFigureScriptWritesItsFigures) {
    const auto scripts = files_in(source / "examples/figures", ".sh");
    ASSERT_GE(scripts.size(), 6u);
    const std::regex shot("--shot \"\\$out/([^\"]*)\"");
    for (const fs::path& script : scripts) {
        ASSERT_EQ(run("sh '" + script.string() + "' '" + viewer + "' out"), 0) << script << "\n" << said_;
        const std::string text = read_file(script.string());
        std::size_t figures = 0;
        for (std::sregex_iterator it(text.begin(), text.end(), shot), end; it != end; ++it, ++figures) {
            const fs::path file = folder_ / "out" / (*it)[1].str();
            ASSERT_TRUE(fs::exists(file)) << script;
            const bool bare = text.find("--set legend=off") != std::string::npos;  // nothing to write into it
            if (!bare || file.extension() != ".svg") expect_figure(file);
        }
        EXPECT_GT(figures, 0u) << script;
    }
}

/// The page shows what the scripts do: the same commands, with ./run viewer2d and out/.
TEST_F(Examples, ThePageOfFiguresShowsTheScripts) {
    const std::string page = read_file((source / "docs/figures.md").string());
    for (const fs::path& script : files_in(source / "examples/figures", ".sh")) {
        std::string text = read_file(script.string());
        const std::string first = "viewer=$1 out=${2:-.}\n";
        ASSERT_NE(text.find(first), std::string::npos) << script;
        text = text.substr(text.find(first) + first.size());
        text = std::regex_replace(text, std::regex("\"\\$viewer\""), "./run viewer2d");
        text = std::regex_replace(text, std::regex("\"\\$out/([^\"]*)\""), "out/$1");
        EXPECT_NE(page.find(text), std::string::npos) << script << "\n" << text;
    }
}

TEST_F(Examples, TheAddedHeuristicIsOneMethodMore) {
    const std::string program = SIGHTLINE_ADDED_HEURISTIC;
    ASSERT_EQ(run(program + " --help"), 0);
    EXPECT_NE(said_.find("\n  crowd "), std::string::npos) << said_;
    EXPECT_NE(said_.find("\n  published "), std::string::npos);
    ASSERT_EQ(run(program + " rooms --headless --method crowd --budget 5% --do 'step 9; back 4; explain; run' "
                            "--stats out/stats.json --shot out/crowd.svg"),
              0)
        << said_;
    EXPECT_NE(read_file((folder_ / "out/stats.json").string()).find("\"method\": \"crowd\""), std::string::npos);
    expect_figure(folder_ / "out/crowd.svg");
    EXPECT_EQ(run(viewer + " rooms --headless --method crowd"), 2) << "only the example knows it";
    // Its sidecar opens in the program that knows the method.
    EXPECT_EQ(run(program + " --headless --state out/crowd.svg.json"), 0) << said_;
    EXPECT_EQ(said_.find("warning"), std::string::npos) << said_;
}

/// What a page shows: a command (lines that end in \ joined), or a line that the command before it prints.
struct Shown {
    bool is_command = false;
    std::string text;
};

/// From the fenced blocks of a page: commands that begin with one of `starts`, and the lines of blocks of text.
std::vector<Shown> shown_in(const fs::path& page, std::span<const std::string> starts) {
    std::vector<Shown> shown;
    std::istringstream lines(read_file(page.string()));
    bool fenced = false, output = false, joined = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            fenced = !fenced;
            output = fenced && line == "```text";
            joined = false;
        } else if (output) {
            shown.push_back({false, line});
        } else if (joined) {
            shown.back().text += "\n" + line;
            joined = line.ends_with('\\');
        } else if (fenced && std::any_of(starts.begin(), starts.end(),
                                         [&](const std::string& start) { return line.starts_with(start); })) {
            shown.push_back({true, line});
            joined = line.ends_with('\\');
        }
    }
    return shown;
}

std::vector<fs::path> pages() {
    auto pages = files_in(source / "docs", ".md");
    pages.push_back(source / "README.md");
    pages.push_back(source / "examples/added_heuristic/README.md");
    return pages;
}

const std::map<std::string, std::string> programs{{"./run viewer2d", viewer},
                                                  {"./run viewer3d", SIGHTLINE_VIEWER3D},
                                                  {"build/release/examples/viewer2d_crowd", SIGHTLINE_ADDED_HEURISTIC}};

std::vector<Shown> shown_in(const fs::path& page) {
    std::vector<std::string> starts;
    for (const auto& [start, program] : programs) starts.push_back(start);
    return shown_in(page, starts);
}

/// A page each, so that they run beside each other.
class Documents : public Examples, public testing::WithParamInterface<fs::path> {};

TEST_P(Documents, EveryCommandWorksAndPrintsWhatThePageShows) {
    const fs::path& page = GetParam();
    const bool freedoom = !installed_maps().empty();
    bool skipped = false;
    for (const Shown& shown : shown_in(page)) {
        if (!shown.is_command) {
            if (skipped) continue;
            EXPECT_NE(said_.find(shown.text), std::string::npos) << page << ": not printed: " << shown.text;
            continue;
        }
        skipped = !freedoom && shown.text.find("freedoom") != std::string::npos;
        if (skipped) continue;
        std::string command;
        for (const auto& [start, program] : programs)
            if (shown.text.starts_with(start)) command = program + shown.text.substr(start.size());
        // What opens a window is opened without one.
        if (command.find("--headless") == std::string::npos && command.find("--list") == std::string::npos)
            command += " --headless";
        EXPECT_EQ(run(command), 0) << page << ":\n" << shown.text << "\n" << said_;
        if (command.find("--state") != std::string::npos) {
            EXPECT_EQ(said_.find("warning"), std::string::npos) << page << ":\n" << shown.text << "\n" << said_;
        }
    }
}

/// Letters and digits alone.
std::string name_of(const fs::path& page) {
    std::string name = fs::relative(page, source).replace_extension().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Pages, Documents, testing::ValuesIn(pages()),
                         [](const auto& page) { return name_of(page.param); });

TEST(DocumentPages, HoldCommandsAndWhatTheyPrint) {
    std::ptrdiff_t commands = 0, lines = 0;
    for (const fs::path& page : pages())
        for (const Shown& shown : shown_in(page)) ++(shown.is_command ? commands : lines);
    EXPECT_GE(commands, 30);
    EXPECT_GE(lines, 10);
}

}  // namespace
}  // namespace sightline
