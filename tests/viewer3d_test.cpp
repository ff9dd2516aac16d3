// The 3D viewer without a window: options in, files out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/viewer2d_support.h"

namespace sightline {
namespace {

using namespace test;

class Viewer3d : public Viewer2dRun {
protected:
    Viewer3d() {
        program = "viewer3d";
        path = SIGHTLINE_VIEWER3D;
    }
};

TEST_F(Viewer3d, MeasuresAndReportsTheConditions) {
    good({"city:10k", "--budget", "10%", "--set", "reference_size=320x240", "--stats", "s.json"});
    const Json stats = Json::parse(read("s.json"));
    EXPECT_EQ(stats["reference"], "item buffer 320x240");
    EXPECT_EQ(stats["approximate"], true);
    EXPECT_GT(stats["visible"], 50);
    EXPECT_LE(stats["visible_rendered"], stats["visible"]);
    EXPECT_LE(stats["rendered"], stats["budget"]);
    EXPECT_EQ(stats["unassigned"], 0);
    EXPECT_GT(stats["wrong_pixels"], 0);
    EXPECT_LT(stats["wrong_pixels"], 0.5);
    EXPECT_FALSE(stats.contains("item_buffer"));
}

TEST_F(Viewer3d, DrawingEverythingInViewMissesNothing) {
    for (const char* method : {"view", "everything", "published", "layers", "centroid"}) {
        good({"city:10k", "--method", method, "--budget", "unlimited", "--set", "reference_size=320x240", "--stats",
              "s.json"});
        const Json stats = Json::parse(read("s.json"));
        EXPECT_EQ(stats["coverage"], 1) << method;
        EXPECT_EQ(stats["wrong_pixels"], 0) << method;
    }
}

TEST_F(Viewer3d, AFrozenPictureOpensAgainFromItsSidecar) {
    good({"bottleneck", "--size", "400x300", "--do",
          "step 40; freeze; orbit 30,20; zoom 0.5; select last; note text cell:last here; set slice=x; shot a.svg; "
          "stats s.json"});
    const Json first = Json::parse(read("s.json"));
    good({"--state", "a.svg.json", "--do", "shot b.svg; stats t.json"});
    const Json again = Json::parse(read("t.json"));
    EXPECT_EQ(first["state_hash"], again["state_hash"]);
    EXPECT_EQ(read("a.svg"), read("b.svg"));
    EXPECT_NE(read("a.svg").find("<image"), std::string::npos);
    EXPECT_NE(read("a.svg").find("here"), std::string::npos);
}

TEST_F(Viewer3d, FlyingShowsTheFrameThatSteppingReaches) {
    good({"city:10k", "--budget", "5%", "--do", "path test; path frame 3; fly off; stats flown.json; eye 0,0,2"});
    const Json flown = Json::parse(read("flown.json"));
    good({"city:10k", "--budget", "5%", "--do", "path test; path frame 3; path stop; seek start; run; stats s.json"});
    EXPECT_EQ(flown["state_hash"], Json::parse(read("s.json"))["state_hash"]);
    EXPECT_GT(flown["steps"], 0);
}

TEST_F(Viewer3d, PathsAreKeptInFiles) {
    good({"city:10k", "--do", "path street; path save p.json; path open p.json; path save q.json"});
    EXPECT_EQ(read("p.json"), read("q.json"));
    EXPECT_EQ(Json::parse(read("p.json"))["frames"].size(), 160u);
}

TEST_F(Viewer3d, APathIsMeasuredFrameByFrame) {
    const std::vector<std::string> usual{"city:10k", "--budget", "5%", "--set", "reference_size=160x120"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), usual.begin(), usual.end());
        good(more);
    };
    with({"--path", "street", "--frames", "3", "--stats", "all.json"});
    const Json all = Json::parse(read("all.json"));
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0]["frame"], 0);
    EXPECT_EQ(all[2]["frame"], 159);
    for (const Json& row : all) {
        with({"--path", "street", "--frame", std::to_string(row["frame"].get<int>()), "--stats", "one.json"});
        const Json one = Json::parse(read("one.json"));
        EXPECT_EQ(one["state_hash"], row["stats"]["state_hash"]);
        EXPECT_EQ(one["coverage"], row["stats"]["coverage"]);
    }
    EXPECT_NE(all[0]["stats"]["state_hash"], all[2]["stats"]["state_hash"]);

    // One of a file goes the same way, also in a scene of another origin.
    with({"--do", "path street; path save p.json"});
    with({"--path", "p.json", "--frames", "3", "--stats", "file.json"});
    const Json file = Json::parse(read("file.json"));
    ASSERT_EQ(file.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(file[i]["stats"]["state_hash"], all[i]["stats"]["state_hash"]);

    bad({"city:10k", "--path", "nosuch"}, "nosuch");
    bad({"city:10k", "--path", "street", "--frame", "160"}, "160");
    bad({"city:10k", "--frame", "3"}, "--path");
    bad({"city:10k", "--path", "street", "--frames", "0", "--stats", "-"}, "--frames");
    bad({"city:10k", "--path", "street", "--frames", "2"}, "--stats");
    bad({"city:10k", "--path", "street", "--eye", "1,2,3"}, "--eye");
}

TEST_F(Viewer3d, BadInputIsNamedAndLeavesNothing) {
    bad({"nowhere"}, "nowhere");
    bad({"city:7"}, "city:7");
    bad({"city:10k", "--eye", "1,2"}, "X,Y,Z");
    bad({"bottleneck", "--eye", "nan,0,0"}, "nan");
    bad({"bottleneck", "--eye", "1,1,1", "--look-at", "1,1,1"}, "look");
    bad({"bottleneck", "--fov", "180"}, "fov");
    bad({"bottleneck", "--set", "reference_size=0x0"}, "reference_size");
    bad({"bottleneck", "--do", "path nosuch"}, "nosuch");
    write("empty.obj", "");
    bad({"empty.obj"}, "empty.obj");
}

TEST_F(Viewer3d, AStateOfTheOtherDimensionIsRefused) {
    program = "viewer2d";
    path = SIGHTLINE_VIEWER2D;
    good({"bottleneck", "--do", "save flat.json"});
    program = "viewer3d";
    path = SIGHTLINE_VIEWER3D;
    bad({"--state", "flat.json"}, "viewer2d");
}

TEST_F(Viewer3d, ASceneWithoutTrianglesIsAScene) {
    write("points.obj", "v 0 0 0\nv 1 0 0\n");
    const Result result = headless({"points.obj", "--stats", "s.json", "--shot", "p.png", "--size", "200x150"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("empty"), std::string::npos) << result.err;
    EXPECT_EQ(Json::parse(read("s.json"))["coverage"], nullptr);
}

}  // namespace
}  // namespace sightline
