// The program itself, as a person runs it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"
#include "core/session/condition.h"
#include "core/session/settings_table.h"
#include "shell/commands/command_table.h"
#include "tests/scene/scene_support.h"
#include "tests/viewer2d/viewer2d_support.h"

namespace sightline {
namespace {

using namespace test;
class Viewer2d : public Viewer2dRun {};

TEST_F(Viewer2d, ListsTheCatalogue) {
    const Result result = run({"--list"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    for (const CatalogueRow<2>& row : catalogue()) {
        EXPECT_NE(result.out.find(row.id), std::string::npos) << row.id;
        EXPECT_NE(result.out.find(row.lesson), std::string::npos) << row.id;
    }
}

TEST_F(Viewer2d, HelpIsComplete) {
    const Result result = run({"--help"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    for (const char* option : {"SCENE",    "--list",   "--headless", "--eye",    "--look-at", "--fov",   "--method",
                               "--preset", "--set",    "--settings", "--budget", "--steps",   "--until", "--do",
                               "--shot",   "--panels", "--size",     "--font",   "--state",   "--trace", "--stats"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
    for (const Method<2>& method : method_table<2>()) {
        EXPECT_NE(result.out.find(method.sentence), std::string::npos) << method.id;
    }
    EXPECT_NE(result.out.find("[approximate]"), std::string::npos);
    EXPECT_NE(result.out.find("[conservative]"), std::string::npos);
    for (const Preset& preset : presets()) EXPECT_NE(result.out.find(preset.title), std::string::npos);
    for (const SettingRow& row : settings_table()) {
        if (row.dimension == 3) {
            EXPECT_EQ(result.out.find(row.help), std::string::npos) << row.name;
            continue;
        }
        EXPECT_NE(result.out.find(row.name), std::string::npos) << row.name;
        EXPECT_NE(result.out.find(row.help), std::string::npos) << row.name;
        EXPECT_NE(result.out.find(row.values), std::string::npos) << row.name;
    }
    for (const Command<2>& command : command_table<2>()) EXPECT_NE(result.out.find(command.text), std::string::npos);
    for (const RecordField<2>& field : record_fields<2>()) EXPECT_NE(result.out.find(field.help), std::string::npos);
}

TEST_F(Viewer2d, SceneTakesAStateFileToo) {
    good({"rooms", "--do", "step 7; bookmark mine; save kept.json"});
    good({"--state", "kept.json", "--stats", "named.json", "--do", "save named-again.json"});
    good({"kept.json", "--stats", "bare.json", "--do", "save bare-again.json"});
    const Json bare = Json::parse(read("bare.json")), named = Json::parse(read("named.json"));
    EXPECT_EQ(bare["state_hash"], named["state_hash"]);
    EXPECT_EQ(bare["scene"], "rooms");
    EXPECT_EQ(bare["steps"], 7) << "it stays where the file says";
    EXPECT_EQ(read("bare-again.json"), read("named-again.json"));
    bad({"kept.json", "--cells", "c.cells", "--stats", "s.json"}, "kept.json is a state file");
    bad({"kept.json", "--state", "kept.json"}, "kept.json: ");
    bad({"kept.json", "--eye", "1,x", "--stats", "s.json"}, "1,x");
}

TEST_F(Viewer2d, AStateOpensAnotherSceneWhereOneIsNamed) {
    good({"rooms", "--do", "step 7; select 3", "--eye", "1,1", "--shot", "kept.svg"});
    const Json same = stats({"rooms", "--state", "kept.svg.json"});
    EXPECT_EQ(same["steps"], 7) << "the scene that it was made with";
    const Result other = run({"--headless", "bottleneck", "--state", "kept.svg.json", "--stats", "other.json"});
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_NE(other.err.find("another scene"), std::string::npos) << other.err;
    const Json stats = Json::parse(read("other.json"));
    EXPECT_EQ(stats["scene"], "bottleneck");
    EXPECT_EQ(stats["steps"], 0);
}

TEST_F(Viewer2d, AStateUnderAutoFollowsTheSceneThatIsNamed) {
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);  // of the program; each test is a process
    good({"rooms", "--method", "layers", "--budget", "7", "--do", "save plain.json"});
    std::string text = read("plain.json");
    const std::string off = "\"auto\": \"off\"";
    ASSERT_NE(text.find(off), std::string::npos);
    write("kept.json", text.replace(text.find(off), off.size(), "\"auto\": \"on\""));
    const auto panels = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--state", "kept.json", "--do", "panels"});
        const Result result = headless(std::move(arguments));
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    };
    EXPECT_EQ(panels({}).find("; measured 2"), std::string::npos) << "as it was saved";
    EXPECT_NE(panels({"bottleneck"}).find("; measured 2"), std::string::npos);
    const Json by_hand = stats({"--state", "kept.json", "--method", "flux"});
    EXPECT_EQ(by_hand["method"], "flux");
    good({"--state", "kept.json", "--method", "flux", "--do", "save by-hand.json"});
    EXPECT_NE(read("by-hand.json").find(off), std::string::npos);
}

TEST_F(Viewer2d, WhatCannotBeIsRefusedBeforeTheRun) {
    bad({"--state", ""}, "--state '': is empty");
    bad({""}, "SCENE '': is empty");
    bad({"rooms", "--method", ""}, "--method '': is empty");
    good({"rooms", "--do", ""});
    // Nothing of the run is done: it would write the statistics of the flight.
    bad({"rooms", "--shot", "a.bmp", "--stats", "s.json"}, "unknown extension .bmp; use .png, .svg or .pdf");
    bad({"rooms", "--shot", "a", "--trace", "s.json"}, "no extension");
    EXPECT_FALSE(fs::exists(folder / "s.json"));
    good({"rooms", "--shot", "fig.png"});
    bad({"--state", "fig.png"}, "fig.png: is not a state file: its sidecar is fig.png.json");
    good({"--state", "fig.png.json"});
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
    const auto cut = this->stats({"bottleneck", "--method", "view"});
    EXPECT_EQ(cut["approximate"], true);
    EXPECT_EQ(cut["guarantee"], "conservative, cut short by the budget");
    const auto whole = this->stats({"bottleneck", "--method", "view", "--budget", "unlimited"});
    EXPECT_EQ(whole["approximate"], false);
    EXPECT_EQ(whole["guarantee"], "conservative");
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
    const Json prototype = stats({"bottleneck", "--preset", "prototype-2d"});
    EXPECT_NE(prototype["state_hash"], plain["state_hash"]);
    EXPECT_EQ(prototype["cells"], plain["cells"]) << "a preset leaves the cells alone";
    EXPECT_NE(stats({"bottleneck", "--preset", "paper-3d"})["state_hash"], prototype["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--eye", "4,1"})["state_hash"], plain["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--look-at", "0,8"})["state_hash"], plain["state_hash"]);
    EXPECT_NE(stats({"bottleneck", "--fov", "20"})["state_hash"], plain["state_hash"]);
    // --set goes on top of --preset, whatever their order.
    EXPECT_EQ(stats({"bottleneck", "--set", "seeds=hull", "--preset", "paper-3d", "--budget", "7"})["state_hash"],
              stats({"bottleneck", "--preset", "paper-3d", "--set", "seeds=hull", "--budget", "7"})["state_hash"]);
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

}  // namespace
}  // namespace sightline
