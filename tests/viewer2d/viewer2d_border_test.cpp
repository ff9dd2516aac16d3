// What the program does with bad, odd and extreme input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include "tests/scene/scene_support.h"
#include "tests/viewer2d/viewer2d_support.h"

namespace sightline {
namespace {

using namespace test;
class Viewer2dBorder : public Viewer2dRun {};

TEST_F(Viewer2dBorder, WrongUsageIsOneLineAndExitTwo) {
    bad({"--nonsense"}, "nonsense");
    for (const char* size :
         {"1280", "x", "1280x", "x720", "639x400", "640x399", "1280x99999", "-1280x720", "1280x720x2"})
        bad({"--window", size}, "--window");
    bad({"--window", "1280x720"}, "--headless");
    for (const char* scale : {"0", "0.49", "4.01", "-1", "nan", "1e999", "big"}) bad({"--scale", scale}, "--scale");
    bad({"--scale", "2"}, "--headless");
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
    bad({"bottleneck", "--state", "s.json"}, "s.json: no such file");
}

TEST_F(Viewer2dBorder, UnreadableInputIsOneLineAndExitTwo) {
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

TEST_F(Viewer2dBorder, WhatCannotBeWrittenIsExitOneAndLeavesNothing) {
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

TEST_F(Viewer2dBorder, OddScenesRunAndSayWhatTheyDid) {
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

TEST_F(Viewer2dBorder, TheEyeIsGivenInTheCoordinatesOfTheFile) {
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

TEST_F(Viewer2dBorder, ExtremeSettingsEnd) {
    for (const char* set :
         {"error_bound=1e-300", "error_bound=1", "penalty_amount=1e6", "penalty_amount=0", "reference_size=1",
          "reference_size=16777216", "zoom=1000", "zoom=0.01", "zoom_x=1e308", "zoom_x=-1.7e308", "zoom_y=1e20"}) {
        SCOPED_TRACE(set);
        good({"bottleneck", "--set", "zoom_at=point", "--set", set, "--shot", "a.svg", "--stats", "s.json"});
    }
}

TEST_F(Viewer2dBorder, WithoutADisplayItDoesTheSameAndSaysSo) {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);  // which shows nothing, so it is no display
    const Result result = run({"bottleneck", "--steps", "3"});
    unsetenv("SDL_VIDEODRIVER");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.error_lines(), 1u);
    EXPECT_EQ(result.err.find("viewer2d: no display"), 0u) << result.err;
}

}  // namespace
}  // namespace sightline
