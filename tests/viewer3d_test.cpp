// The 3D viewer without a window: options in, files out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

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

TEST_F(Viewer3d, InsetsAreInTheFigureAndItsSidecar) {
    good({"city:10k", "--size", "400x300", "--do",
          "set reference_size=320x240; step 40; freeze; orbit 30,20; zoom 0.5; set inset=both; shot a.svg"});
    good({"--state", "a.svg.json", "--do", "shot b.svg; set inset=off; shot c.svg"});
    const auto images = [](const std::string& svg) {
        std::size_t count = 0;
        for (std::size_t at = svg.find("<image"); at != std::string::npos; at = svg.find("<image", at + 1)) ++count;
        return count;
    };
    EXPECT_EQ(read("a.svg"), read("b.svg"));
    EXPECT_EQ(images(read("a.svg")), 3u);
    EXPECT_EQ(images(read("c.svg")), 1u);
}

TEST_F(Viewer3d, CellsAreWrittenOnceAndReadAgain) {
    const Result first = good({"city:10k", "--cells", "c.cells", "--stats", "a.json"});
    EXPECT_NE(first.out.find("c.cells"), std::string::npos);
    const std::string file = read("c.cells");
    const Result again = good({"city:10k", "--cells", "c.cells", "--stats", "b.json"});
    EXPECT_EQ(again.out.find("c.cells"), std::string::npos);
    EXPECT_EQ(read("c.cells"), file);
    const Json a = Json::parse(read("a.json")), b = Json::parse(read("b.json"));
    EXPECT_EQ(a["state_hash"], b["state_hash"]);
    EXPECT_EQ(a["cells"], b["cells"]);
    EXPECT_GT(a["ms"]["tessellate"], 0);
    EXPECT_EQ(b["ms"]["tessellate"], 0);
    EXPECT_EQ(b["ms"]["assign"], 0);
    good({"city:10k", "--do", "cells d.cells"});
    EXPECT_EQ(read("d.cells"), file);
    // Settings that the cells do not depend on may change.
    good({"city:10k", "--cells", "c.cells", "--method", "layers", "--set", "heat=order"});
}

TEST_F(Viewer3d, CellsThatDoNotFitAreRefused) {
    good({"city:10k", "--cells", "c.cells"});
    const std::string file = read("c.cells");
    bad({"room", "--cells", "c.cells"}, "another scene");
    bad({"city:20k", "--cells", "c.cells"}, "another scene");
    bad({"city:10k", "--set", "error_bound=0.1", "--cells", "c.cells"}, "error_bound");
    bad({"city:10k", "--set", "tessellation=tree", "--cells", "c.cells"}, "tessellation");
    bad({"--cells", "c.cells"}, "scene");
    bad({"city:10k", "--cells", "."}, ".");
    write("t.cells", file.substr(0, file.size() / 2));
    bad({"city:10k", "--cells", "t.cells"}, "truncated");
    std::string damaged = file;
    damaged[damaged.size() / 2] ^= 1;
    write("t.cells", damaged);
    bad({"city:10k", "--cells", "t.cells"}, "t.cells: is damaged");
    write("t.cells", "v 0 0 0\n");
    bad({"city:10k", "--cells", "t.cells"}, "t.cells");
    EXPECT_EQ(read("c.cells"), file);
    EXPECT_EQ(headless({"city:10k", "--cells", "nowhere/c.cells"}).status, 1);
    program = "viewer2d";
    path = SIGHTLINE_VIEWER2D;
    bad({"bottleneck", "--cells", "c.cells"}, "dimensions");
    good({"bottleneck", "--cells", "flat.cells"});
    good({"bottleneck", "--cells", "flat.cells"});
}

TEST_F(Viewer3d, FlyingShowsTheFrameThatSteppingReaches) {
    good({"city:10k", "--budget", "5%", "--do", "path test; path frame 3; fly off; stats flown.json; eye 0,0,2"});
    const Json flown = Json::parse(read("flown.json"));
    good({"city:10k", "--budget", "5%", "--do", "path test; path frame 3; path stop; seek start; run; stats s.json"});
    EXPECT_EQ(flown["state_hash"], Json::parse(read("s.json"))["state_hash"]);
    EXPECT_GT(flown["steps"], 0);
}

TEST_F(Viewer3d, APathBecomesAFilmOfTwoMethods) {
    good(
        {"city:10k", "--budget", "2%", "--size", "400x200", "--do",
         "set reference_size=320x240; compare method=centroid; path street; film path 0-4 f.png; film path 7-7 g.png"});
    std::set<std::string> pictures;
    for (int i = 1; i <= 5; ++i) pictures.insert(read("f-000" + std::to_string(i) + ".png"));
    EXPECT_EQ(pictures.size(), 5u);
    EXPECT_EQ(files(), 8u);  // and of the second film one, and two sidecars
    const Json sidecar = Json::parse(read("g.png.json"));
    EXPECT_EQ(sidecar["film"]["path"], "street");
    good({"--state", "g.png.json", "--do", "stats opened.json"});
    good({"city:10k", "--budget", "2%", "--do",
          "set reference_size=320x240; path street; path frame 7; path stop; stats flown.json"});
    EXPECT_EQ(Json::parse(read("opened.json"))["state_hash"], Json::parse(read("flown.json"))["state_hash"]);
    bad({"city:10k", "--do", "film path f.png"}, "path");
    bad({"city:10k", "--do", "path street; film path 5-160 f.png"}, "160");
    bad({"city:10k", "--do", "film f.png"}, "FROM-TO");
}

TEST_F(Viewer3d, PathsAreKeptInFiles) {
    good({"city:10k", "--do", "path street; path save p.json; path open p.json; path save q.json"});
    EXPECT_EQ(read("p.json"), read("q.json"));
    EXPECT_EQ(Json::parse(read("p.json"))["frames"].size(), 160u);
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
