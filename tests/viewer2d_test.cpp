// The program itself, as a person runs it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/catalogue.h"
#include "core/session/condition.h"
#include "core/settings/settings_table.h"
#include "core/traversal/methods.h"
#include "shell/commands/commands.h"
#include "tests/scene_support.h"

extern char** environ;

namespace sightline {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Result {
    int status = -1;  ///< 1000 + signal for a crash
    std::string out, err;
    std::size_t error_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }
};

class Viewer2d : public ::testing::Test {
protected:
    Viewer2d() { fs::create_directories(folder); }
    ~Viewer2d() override { fs::remove_all(folder); }

    std::string read(const std::string& name) const {
        std::ifstream in(folder / name, std::ios::binary);
        EXPECT_TRUE(in) << name << " is missing";
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    /// Everything that a run left in the folder.
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
    }

    /// Runs viewer2d in the folder; its output goes to files beside the folder, not into it.
    Result run(std::vector<std::string> arguments) const {
        const std::string out = folder.string() + ".out", err = folder.string() + ".err";
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
        arguments.insert(arguments.begin(), "viewer2d");
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        pid_t child = 0;
        Result result;
        EXPECT_EQ(posix_spawn(&child, SIGHTLINE_VIEWER2D, &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
        int status = 0;
        waitpid(child, &status, 0);
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
        const auto content = [](const std::string& path) {
            std::ifstream in(path, std::ios::binary);
            std::ostringstream text;
            text << in.rdbuf();
            fs::remove(path);
            return text.str();
        };
        result.out = content(out);
        result.err = content(err);
        return result;
    }
    Result headless(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "--headless");
        return run(std::move(arguments));
    }
    /// A run that must do what it is asked, silently.
    Result good(std::vector<std::string> arguments) const {
        const Result result = headless(std::move(arguments));
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result;
    }
    /// Wrong usage or unreadable input: exit 2, one line that names `what`, nothing written.
    void bad(std::vector<std::string> arguments, const std::string& what) const {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        const std::size_t before = files();
        const Result result = headless(std::move(arguments));
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_EQ(result.error_lines(), 1u) << result.err;
        EXPECT_EQ(result.err.find("viewer2d: "), 0u) << result.err;
        EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
        EXPECT_EQ(files(), before) << "something was written";
    }
    Json stats(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--stats", "s.json"});
        good(std::move(arguments));
        return Json::parse(read("s.json"));
    }

    fs::path folder = fs::temp_directory_path() / ("sightline-viewer2d-" + std::to_string(getpid()));
};

TEST_F(Viewer2d, ListsTheCatalogue) {
    const Result result = run({"--list"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    for (const CatalogueRow& row : catalogue()) {
        EXPECT_NE(result.out.find(row.id), std::string::npos) << row.id;
        EXPECT_NE(result.out.find(row.lesson), std::string::npos) << row.id;
    }
}

TEST_F(Viewer2d, HelpIsComplete) {
    const Result result = run({"--help"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    for (const char* option : {"SCENE",    "--list", "--headless", "--eye",   "--look-at", "--fov",  "--method",
                               "--preset", "--set",  "--budget",   "--steps", "--until",   "--do",   "--shot",
                               "--panels", "--size", "--font",     "--state", "--trace",   "--stats"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
    for (const Method<2>& method : method_table<2>()) {
        EXPECT_NE(result.out.find(method.sentence), std::string::npos) << method.id;
    }
    EXPECT_NE(result.out.find("[approximate]"), std::string::npos);
    EXPECT_NE(result.out.find("[conservative]"), std::string::npos);
    for (const Preset& preset : presets()) EXPECT_NE(result.out.find(preset.title), std::string::npos);
    for (const SettingRow& row : settings_table()) {
        EXPECT_NE(result.out.find(row.name), std::string::npos) << row.name;
        EXPECT_NE(result.out.find(row.help), std::string::npos) << row.name;
        EXPECT_NE(result.out.find(row.values), std::string::npos) << row.name;
    }
    for (const Command& command : command_table()) EXPECT_NE(result.out.find(command.text), std::string::npos);
    for (const RecordField<2>& field : record_fields<2>()) EXPECT_NE(result.out.find(field.help), std::string::npos);
}

TEST_F(Viewer2d, StatsHaveEveryFieldOfTheContract) {
    const Json stats = this->stats({"bottleneck"});
    for (const char* text : {"scene", "method", "reference", "stop", "state_hash"})
        EXPECT_TRUE(stats.at(text).is_string()) << text;
    for (const char* count : {"seed", "cells", "primitives", "budget", "steps", "projected", "enqueued", "unseen",
                              "rendered", "visible", "visible_rendered", "inversions"})
        EXPECT_TRUE(stats.at(count).is_number_unsigned()) << count;
    for (const char* number : {"coverage", "oracle"}) EXPECT_TRUE(stats.at(number).is_number_float()) << number;
    EXPECT_TRUE(stats.at("approximate").is_boolean());
    for (const char* part : {"read", "tessellate", "assign", "reference", "traverse", "draw"}) {
        EXPECT_TRUE(stats.at("ms").at(part).is_number()) << part;
        EXPECT_GE(stats["ms"][part], 0) << part;
    }
    for (const char* part : {"scene", "tessellation", "references"})
        EXPECT_GT(stats.at("memory_bytes").at(part), 0) << part;
    for (const char* part : {"degenerate", "duplicate", "not_finite"})
        EXPECT_TRUE(stats.at("dropped").at(part).is_number_unsigned()) << part;

    EXPECT_EQ(stats["scene"], "bottleneck");
    EXPECT_EQ(stats["seed"], find_in_catalogue("bottleneck")->seed);
    EXPECT_EQ(stats["method"], "published");
    EXPECT_EQ(stats["approximate"], true);
    EXPECT_EQ(stats["reference"], "exact");
    EXPECT_EQ(stats["stop"], "budget");
    EXPECT_EQ(stats["rendered"], stats["budget"]);
    EXPECT_EQ(stats["coverage"].get<double>(),
              stats["visible_rendered"].get<double>() / stats["visible"].get<double>());
    EXPECT_EQ(this->stats({"bottleneck", "--method", "view"})["approximate"], false);
    EXPECT_EQ(this->stats({"bottleneck", "--budget", "unlimited"})["stop"], "front empty");
    EXPECT_EQ(this->stats({"bottleneck", "--budget", "unlimited"})["coverage"], 1.0);
}

TEST_F(Viewer2d, OptionsReachTheSession) {
    const Json plain = stats({"bottleneck"});
    EXPECT_EQ(stats({"bottleneck", "--budget", "7"})["rendered"], 7);
    EXPECT_EQ(stats({"bottleneck", "--budget", "50%"})["budget"], std::nearbyint(plain["primitives"].get<int>() / 2.0));
    EXPECT_EQ(stats({"bottleneck", "--method", "layers"})["method"], "layers");
    EXPECT_EQ(stats({"bottleneck", "--set", "tessellation=tree"})["tessellation"], "tree");
    EXPECT_NE(stats({"bottleneck", "--set", "error_bound=0.1", "--set", "jitter=0"})["cells"], plain["cells"]);
    EXPECT_NE(stats({"bottleneck", "--preset", "letter", "--set", "border=inflated"})["state_hash"],
              plain["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--eye", "4,1"})["state_hash"], plain["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--look-at", "0,8"})["state_hash"], plain["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--fov", "20"})["state_hash"], plain["state_hash"]);
    // --set goes on top of --preset, whatever their order.
    EXPECT_EQ(stats({"bottleneck", "--set", "border=inflated", "--preset", "letter", "--budget", "7"})["state_hash"],
              stats({"bottleneck", "--preset", "letter", "--set", "border=inflated", "--budget", "7"})["state_hash"]);
    // Without a scene: the first lesson.
    EXPECT_EQ(stats({})["state_hash"], plain["state_hash"]);
}

TEST_F(Viewer2d, StepsUntilAndCommandsStartAtStepZero) {
    const Json five = stats({"bottleneck", "--steps", "5"});
    EXPECT_EQ(five["steps"], 5);
    EXPECT_EQ(five["stop"], "steps");
    const Json until = stats({"bottleneck", "--until", "step:5"});
    EXPECT_EQ(until["stop"], "breakpoint");
    EXPECT_EQ(until["state_hash"], five["state_hash"]);
    const Json walk = stats({"bottleneck", "--do", "step 9; back 6; seek end; seek 5"});
    EXPECT_EQ(walk["state_hash"], five["state_hash"]);
    const Json still = stats({"bottleneck", "--do", "freeze"});
    EXPECT_EQ(still["steps"], 0);
    EXPECT_EQ(still["stop"], "steps") << "the contract knows no other word";
    EXPECT_EQ(stats({"bottleneck", "--steps", "0"})["steps"], 0);
    EXPECT_EQ(stats({"bottleneck", "--steps", "4000000000"})["stop"], "budget");
    const Json condition = stats({"bottleneck", "--budget", "unlimited", "--until", "visible_share == 0 && count > 0"});
    EXPECT_EQ(condition["stop"], "breakpoint");
    const Json never = stats({"bottleneck", "--budget", "unlimited", "--until", "step < 0"});
    EXPECT_EQ(never["stop"], "front empty");
    EXPECT_NE(good({"bottleneck", "--do", "seek 3; explain"}).out.find("Step 3: cell "), std::string::npos);
}

TEST_F(Viewer2d, TheTraceHoldsEveryStep) {
    good({"bottleneck", "--steps", "12", "--trace", "t.json", "--stats", "s.json"});
    const Json trace = Json::parse(read("t.json")), stats = Json::parse(read("s.json"));
    ASSERT_EQ(trace.at("steps").size(), 12u);
    EXPECT_EQ(trace.at("state_hash"), stats.at("state_hash"));
    std::size_t rendered = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        const Json& step = trace["steps"][i];
        EXPECT_EQ(step.at("step"), i + 1);
        rendered += step.at("primitives").size();
        EXPECT_EQ(step.at("primitives").size(), step.at("rendered_now"));
        EXPECT_EQ(step.at("rendered"), rendered);
        for (const Json& facet : step.at("facets"))
            if (facet.contains("terms")) {
                EXPECT_TRUE(facet["terms"].at("key").is_number());
            }
    }
    EXPECT_EQ(rendered, stats["rendered"]);
}

TEST_F(Viewer2d, WritesFiguresInThreeFormats) {
    good({"bottleneck", "--steps", "12", "--size", "300x200", "--shot", "a.png", "--shot", "a.svg", "--shot", "a.pdf"});
    EXPECT_EQ(read("a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
    const std::string png = read("a.png");
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 300);
    EXPECT_EQ(static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]), 200);
    EXPECT_NE(read("a.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(read("a.pdf").substr(0, 5), "%PDF-");
    for (const char* name : {"a.png.json", "a.svg.json", "a.pdf.json"}) EXPECT_EQ(read(name), read("a.png.json"));
    EXPECT_EQ(files(), 6u) << "no temporary file stays";
    good({"bottleneck", "--budget", "50%", "--size", "84mm", "--font", "7pt", "--panels",
          "step 1; step 12 ; until step:20;end", "--shot", "p.svg"});
    const std::string panels = read("p.svg");
    for (const char* title : {"(a) step 1", "(b) step 12", "(c) step 20"})
        EXPECT_NE(panels.find(title), std::string::npos) << title;
    EXPECT_NE(panels.find("(d) step"), std::string::npos);
}

TEST_F(Viewer2d, ASidecarReopensTheSame) {
    const std::vector<std::vector<std::string>> cases{
        {"bottleneck", "--steps", "12", "--set", "label=solidity", "--set", "heat=count"},
        {"bottleneck", "--panels", "step 2;end", "--font", "7", "--set", "palette=print"},
        {"statue", "--do", "step 8; freeze; eye 3,3; note callout cell:2 \"x; y\"; select 4; back 2"},
        {"cars", "--budget", "16ms"},
        {"wall2", "--set", "two_sided=on", "--method", "centroid"},
        {"lines.geojson", "--fov", "360"},
    };
    write("lines.geojson",
          R"({"type": "MultiLineString", "coordinates": [[[1800000,5200000],[1800010,5200000],[1800010,5200010]],
              [[1800003,5200004],[1800004,5200004]], [[1800003,5200004],[1800004,5200004]]]})");
    for (std::vector<std::string> arguments : cases) {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        arguments.insert(arguments.end(), {"--shot", "a.svg", "--stats", "a.json"});
        EXPECT_EQ(headless(arguments).status, 0);
        good({"--state", "a.svg.json", "--shot", "b.svg", "--stats", "b.json"});
        Json first = Json::parse(read("a.json")), second = Json::parse(read("b.json"));
        EXPECT_EQ(first["state_hash"], second["state_hash"]);
        EXPECT_EQ(read("a.svg"), read("b.svg"));
        EXPECT_EQ(read("a.svg.json"), read("b.svg.json"));
        for (Json* stats : {&first, &second})
            for (const char* part : {"ms", "memory_bytes", "stop"}) stats->erase(part);
        EXPECT_EQ(first, second);
    }
    // Options go on top of a state.
    good({"bottleneck", "--steps", "12", "--shot", "a.svg"});
    EXPECT_EQ(stats({"--state", "a.svg.json", "--steps", "3"})["steps"], 3);
    EXPECT_EQ(stats({"--state", "a.svg.json", "--method", "layers"})["method"], "layers");
}

TEST_F(Viewer2d, WrongUsageIsOneLineAndExitTwo) {
    bad({"--nonsense"}, "nonsense");
    bad({"bottleneck", "streets"}, "streets");
    bad({"bottleneck", "--method"}, "--method");
    bad({"bottleneck", "--method", "nothing"}, "nothing");
    bad({"bottleneck", "--preset", "nothing"}, "nothing");
    bad({"bottleneck", "--set", "colour=red"}, "colour");
    bad({"bottleneck", "--set", "a\nb=1"}, "does not exist");
    bad({"bottleneck", "--set", "jitter=0.5"}, "jitter");
    bad({"bottleneck", "--set", "jitter"}, "FIELD=VALUE");
    bad({"bottleneck", "--budget", "lots"}, "lots");
    bad({"bottleneck", "--budget", "-5"}, "-5");
    bad({"bottleneck", "--steps", "x"}, "--steps");
    bad({"bottleneck", "--steps", "-1"}, "--steps");
    bad({"bottleneck", "--steps", "1.5"}, "--steps");
    bad({"bottleneck", "--until", "rho >"}, "rho >");
    bad({"bottleneck", "--until", "step = 5"}, "==");
    bad({"bottleneck", "--do", "dance"}, "dance");
    bad({"bottleneck", "--do", "step x"}, "step x");
    bad({"bottleneck", "--eye", "nan,1"}, "nan,1");
    bad({"bottleneck", "--eye", "1"}, "X,Y");
    bad({"bottleneck", "--eye", "1e999,1"}, "1e999");
    bad({"bottleneck", "--eye", "3,3", "--look-at", "3,3"}, "look-at");
    bad({"bottleneck", "--fov", "0"}, "fov");
    bad({"bottleneck", "--fov", "x"}, "--fov");
    bad({"bottleneck", "--fov", "nan"}, "--fov");
    bad({"bottleneck", "--shot", "a.gif"}, "a.gif");
    bad({"bottleneck", "--shot", "a.svg", "--size", "huge"}, "huge");
    bad({"bottleneck", "--shot", "a.svg", "--size", "1e30mm"}, "width");
    bad({"bottleneck", "--shot", "a.svg", "--font", "0"}, "font");
    bad({"bottleneck", "--shot", "a.svg", "--font", "-8pt"}, "font");
    bad({"bottleneck", "--shot", "a.svg", "--font", "big"}, "--font");
    bad({"bottleneck", "--shot", "a.svg", "--panels", "step x"}, "step x");
    bad({"bottleneck", "--shot", "a.svg", "--panels", "until rho >"}, "rho >");
    bad({"--state", "missing.json"}, "missing.json");
    bad({"bottleneck", "--state", "s.json"}, "bottleneck");
}

TEST_F(Viewer2d, UnreadableInputIsOneLineAndExitTwo) {
    const std::string wad = test::wad_of(test::room_map("MAP01"));
    write("good.wad", wad);
    write("cut.wad", wad.substr(0, wad.size() / 2));
    write("garbage.json", "{\"format\": \"sightline-scene\", \x01\x02\xff");
    write("cut.json", R"({"format": "sightline-scene", "version": 1, "dimension": 2, "segments": [[0,0,1,)");
    write("binary", std::string("\x7f"
                                "ELF\0\0\0",
                                7));
    write("nothing", "");
    write("type.json", R"({"format": "sightline-scene", "version": 1, "dimension": 2, "segments": [[0,0,1,"x"]]})");
    write("huge.json", R"({"format": "sightline-scene", "version": 1, "dimension": 2, "segments": [[0,0,1,1e300]]})");
    fs::create_directory(folder / "folder");
    bad({"missing.json"}, "missing.json");
    bad({"missing\nline.json"}, "missing");
    bad({"nosuchscene"}, "nosuchscene");
    bad({"cut.wad"}, "cut.wad");
    bad({"good.wad#MAP07"}, "MAP07");
    bad({"garbage.json"}, "garbage.json");
    bad({"cut.json"}, "line 1");
    bad({"binary"}, "binary");
    bad({"nothing"}, "empty");
    bad({"type.json"}, "/segments/0/3");
    bad({"huge.json"}, "huge.json");
    bad({"folder"}, "folder");
    bad({"--state", "good.wad"}, "good.wad");
    bad({"--state", "cut.json"}, "cut.json");
    EXPECT_EQ(headless({"good.wad"}).status, 0);
}

TEST_F(Viewer2d, WhatCannotBeWrittenIsExitOneAndLeavesNothing) {
    write("there.svg", "old");
    fs::create_directory(folder / "folder.svg");
    const std::size_t before = files();
    const std::vector<std::string> targets{"missing/a.svg", "there.svg/a.svg", "folder.svg"};
    for (const std::string& target : targets) {
        const Result result = headless({"bottleneck", "--steps", "3", "--shot", target});
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_EQ(result.error_lines(), 1u) << result.err;
        EXPECT_NE(result.err.find(target), std::string::npos) << result.err;
        EXPECT_EQ(files(), before);
    }
    EXPECT_EQ(headless({"bottleneck", "--steps", "3", "--stats", "missing/s.json"}).status, 1);
    EXPECT_EQ(headless({"bottleneck", "--steps", "3", "--trace", "missing/t.json"}).status, 1);
    EXPECT_EQ(headless({"bottleneck", "--steps", "3", "--do", "save missing/s.json"}).status, 1);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(read("there.svg"), "old");
    if (geteuid() != 0) {  // root may write anywhere
        fs::create_directory(folder / "locked");
        chmod((folder / "locked").c_str(), 0500);
        EXPECT_EQ(headless({"bottleneck", "--steps", "3", "--shot", "locked/a.svg"}).status, 1);
        EXPECT_TRUE(fs::is_empty(folder / "locked"));
    }
    // What is no file is not replaced by one; a link is followed.
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const Result pipe = headless({"bottleneck", "--steps", "3", "--stats", "pipe"});
    EXPECT_EQ(pipe.status, 1) << pipe.err;
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
    write("real.json", "old");
    fs::create_symlink("real.json", folder / "link.json");
    good({"bottleneck", "--steps", "3", "--stats", "link.json"});
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_EQ(Json::parse(read("real.json"))["steps"], 3);
    fs::create_symlink("nowhere/x.json", folder / "broken.json");
    EXPECT_EQ(headless({"bottleneck", "--steps", "3", "--stats", "broken.json"}).status, 1);
}

std::string scene_text(const std::string& segments) {
    return R"({"format": "sightline-scene", "version": 1, "dimension": 2, "segments": [)" + segments + "]}";
}

TEST_F(Viewer2d, OddScenesRunAndSayWhatTheyDid) {
    struct Case {
        const char *name, *segments;
        std::vector<std::string> arguments;
        const char* warning;  ///< part of the one warning; nullptr: none
    };
    const Case cases[] = {
        {"empty", "", {}, "empty"},
        {"one", "[0,0,1,0]", {}, nullptr},
        {"collinear", "[0,0,1,0],[1,0,2,0],[3,0,7,0],[2,0,5,0]", {"--eye", "3,1", "--look-at", "3,0"}, nullptr},
        {"line_through_the_eye", "[0,0,1,0],[1,0,2,0],[3,0,7,0]", {"--eye", "9,0", "--look-at", "0,0"}, nullptr},
        {"one_cell", "[0,0,1,0],[0,0,0,1],[0,1,1,0]", {"--set", "error_bound=1"}, nullptr},
        {"eye_on", "[0,0,4,0],[0,2,4,2]", {"--eye", "1,0", "--look-at", "2,2"}, "eye lies on 1 segment"},
        {"eye_on_end", "[0,0,4,0],[0,2,4,2]", {"--eye", "4,0", "--look-at", "2,2"}, "eye lies on 1 segment"},
        {"far", "[0,0,1,0],[0,1,1,1]", {"--eye", "1e9,1e9", "--look-at", "0,0"}, nullptr},
        {"away", "[0,0,1,0],[0,1,1,1]", {"--eye", "-5,0", "--look-at", "-9,0"}, nullptr},
        {"dropped", "[0,0,1,0],[1,0,0,0],[2,2,2,2]", {}, "dropped 1 of zero length, 1 duplicates"},
        {"tiny", "[0,0,1e-140,0],[0,1e-140,1e-140,1e-140]", {}, nullptr},
        {"large", "[0,0,1e140,0],[0,1e140,1e140,1e140]", {}, nullptr},
        {"crossing",
         "[0,0,1,1],[0,1,1,0],[0.5,0,0.5,1],[0,0.5,1,0.5]",
         {"--eye", "0.5,0.5", "--look-at", "1,0.7"},
         "eye lies on 4"},
    };
    for (const Case& c : cases)
        for (const char* tessellation : {"delaunay", "tree"})
            for (const char* border : {"inflated", "none"}) {
                SCOPED_TRACE(std::string(c.name) + " " + tessellation + " " + border);
                const std::string file = std::string(c.name) + ".json";
                write(file, scene_text(c.segments));
                std::vector<std::string> arguments{file,
                                                   "--set",
                                                   std::string("tessellation=") + tessellation,
                                                   "--set",
                                                   std::string("border=") + border,
                                                   "--set",
                                                   "label=solidity",
                                                   "--shot",
                                                   "a.png",
                                                   "--size",
                                                   "300x300",
                                                   "--stats",
                                                   "s.json",
                                                   "--trace",
                                                   "t.json"};
                arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
                const Result result = headless(arguments);
                ASSERT_EQ(result.status, 0) << result.err;
                if (std::string(border) == "inflated") {
                    EXPECT_EQ(result.error_lines(), c.warning ? 1u : 0u) << result.err;
                }
                if (c.warning) {
                    EXPECT_NE(result.err.find("warning: "), std::string::npos) << result.err;
                    EXPECT_NE(result.err.find(c.warning), std::string::npos) << result.err;
                }
                const Json stats = Json::parse(read("s.json"));
                const bool reachable = std::string(border) == "inflated" || std::string(tessellation) == "tree";
                if (stats["visible"] == 0) {
                    EXPECT_TRUE(stats["coverage"].is_null());
                } else if (reachable) {
                    EXPECT_EQ(stats["coverage"], 1.0);
                }
            }
}

TEST_F(Viewer2d, TheEyeIsGivenInTheCoordinatesOfTheFile) {
    // A square room with a pillar, once at the origin and once far away.
    const auto room = [](double x, double y) {
        std::ostringstream text;
        text.precision(17);
        text << R"({"type": "MultiLineString", "coordinates": [)";
        const auto line = [&](double ax, double ay, double bx, double by, const char* end) {
            text << "[[" << x + ax << "," << y + ay << "],[" << x + bx << "," << y + by << "]]" << end;
        };
        line(0, 0, 16, 0, ",");
        line(16, 0, 16, 16, ",");
        line(16, 16, 0, 16, ",");
        line(0, 16, 0, 0, ",");
        line(7, 8, 9, 8, ",");
        line(7, 12, 9, 12, "]}");
        return text.str();
    };
    write("near.geojson", room(0, 0));
    write("far.geojson", room(1.8e6, 5.2e6));
    const Json near = stats({"near.geojson", "--eye", "8,2", "--look-at", "8,8"});
    const Json far = stats({"far.geojson", "--eye", "1800008,5200002", "--look-at", "1800008,5200008"});
    EXPECT_EQ(near["visible"], far["visible"]);
    EXPECT_EQ(near["visible"], 4) << "three walls and the pillar, not what stands behind it";
    EXPECT_EQ(near["steps"], far["steps"]);
    EXPECT_EQ(near["cells"], far["cells"]);
    // The command of the same name means the same.
    const Json moved = stats({"far.geojson", "--do", "eye 1800008,5200002; look 1800008,5200008; run"});
    EXPECT_EQ(moved["state_hash"], far["state_hash"]);
}

TEST_F(Viewer2d, ExtremeSettingsEnd) {
    for (const char* set : {"error_bound=1e-300", "error_bound=1", "penalty_amount=1e6", "penalty_amount=0",
                            "reference_size=1", "reference_size=16777216", "zoom=1000", "zoom=0.01"}) {
        SCOPED_TRACE(set);
        good({"bottleneck", "--set", set, "--shot", "a.svg", "--stats", "s.json"});
    }
}

TEST_F(Viewer2d, WithoutHeadlessItSaysThatTheWindowComesLater) {
    const Result result = run({"bottleneck", "--steps", "3"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.error_lines(), 1u);
    EXPECT_EQ(result.err.find("viewer2d: the window comes"), 0u) << result.err;
}

}  // namespace
}  // namespace sightline
