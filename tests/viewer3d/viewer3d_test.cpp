// The 3D viewer without a window: options in, files out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>

#include <csignal>
#include <set>

#include "shell/lesson/lesson.h"
#include "tests/viewer2d/viewer2d_support.h"

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

TEST_F(Viewer3d, ItsLessonsPlayToTheirEnd) {
    std::size_t played = 0;
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != 3) continue;
        std::string script = "lesson " + lesson.id;
        for (std::size_t part = 0; part < lesson.parts.size(); ++part) {
            for (std::size_t beat = 0; beat < lesson.parts[part].beats.size(); ++beat) script += "; next";
            if (part + 1 < lesson.parts.size()) script += "; next";
        }
        good({"--do", script, "--stats", "s.json"});
        EXPECT_EQ(Json::parse(read("s.json"))["visible_rendered"], Json::parse(read("s.json"))["visible"])
            << "the last part completes the picture";
        ++played;
    }
    EXPECT_GT(played, 0u);
}

TEST_F(Viewer3d, ItsLessonsShowTheNumbersThatTheySpeakOf) {
    std::size_t shown = 0;
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != 3) continue;
        for (std::size_t part = 0; part < lesson.parts.size(); ++part) {
            std::string script = "lesson " + lesson.id + " " + std::to_string(part + 1);
            for (const Beat& beat : lesson.parts[part].beats) {
                script += "; next";
                if (beat.shows.empty()) continue;
                const std::string out = good({"--do", script, "--stats", "s.json"}).out;
                const Json stats = Json::parse(read("s.json"));
                const std::string found = std::to_string(stats["visible_rendered"].get<int>()),
                                  all = std::to_string(stats["visible"].get<int>());
                const std::string line = std::to_string(stats["rendered"].get<int>()) + " drawn, " +
                                         (found == all ? "all " + all : found + " of " + all) + " visible found\n" +
                                         out;
                for (const std::string& words : beat.shows) {
                    ++shown;
                    EXPECT_NE(line.find(words), std::string::npos) << script << ": '" << words << "' is not in\n"
                                                                   << line;
                }
            }
        }
    }
    EXPECT_GT(shown, 5u);
}

TEST_F(Viewer3d, ReferencesAreDrawnInSoftwareWhereAPersonWantsItOrThereIsNoOpenGl) {
    const std::vector<std::string> usual{"city:10k", "--budget", "10%", "--set", "reference_size=320x240",
                                         "--stats",  "s.json"};
    const auto stats = [&] { return Json::parse(read("s.json")); };
    good(usual);
    const Json opengl = stats();
    std::vector<std::string> asked = usual;
    asked.insert(asked.end(), {"--set", "reference=software"});
    good(asked);
    const Json software = stats();
    EXPECT_EQ(software["reference"], "software item buffer 320x240");
    EXPECT_EQ(software["state_hash"], opengl["state_hash"]);
    EXPECT_NEAR(software["visible"].get<double>(), opengl["visible"].get<double>(), 3);
    EXPECT_NEAR(software["wrong_pixels"].get<double>(), opengl["wrong_pixels"].get<double>(), 0.001);
    // An OpenGL that is too old.
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    setenv("MESA_GLSL_VERSION_OVERRIDE", "120", 1);
    const Result blind = headless(usual);
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    EXPECT_EQ(blind.status, 0) << blind.err;
    if (stats()["reference"] == opengl["reference"]) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(stats()["visible"], software["visible"]);
    EXPECT_EQ(stats()["reference"], software["reference"]);
    EXPECT_EQ(blind.error_lines(), 1u) << blind.err;
    EXPECT_EQ(blind.err.find("warning: the reference is drawn in software: OpenGL 3.3 is needed"), 0u) << blind.err;
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
    bad({"city:10k", "--do", "path street; film path 160-170 f.png"}, "159");
    bad({"city:10k", "--do", "film f.png"}, "FROM-TO");
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
    bad({"bottleneck", "--set", "reference_size=0x0"}, "reference_size");
    bad({"bottleneck", "--set", "reference_size=9000x9000"}, "reference_size");
    bad({"bottleneck", "--size", "0x0"}, "size '0x0'");
    bad({"bottleneck", "--do", "path nosuch"}, "nosuch");
    write("empty.obj", "");
    bad({"empty.obj"}, "empty.obj: the file is empty");
}

TEST_F(Viewer3d, AnotherFormatBehindAKnownEndingIsNamed) {
    const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1", 20), text = "Dear all,\nhere is the scene.\n";
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (const char* ending : {"obj", "ply", "stl", "off", "gltf", "glb", "fbx", "dae", "3ds", "3mf", "x", "blend"}) {
        const std::string name = std::string("scene.") + ending;
        write(name, png);
        bad({name}, name + ": ");
        bad({name}, "(it begins like a PNG picture)");
        write(name, text);
        bad({name}, name + ": ");
    }
    for (const char* name : {"text.ply", "text.stl", "text.off"}) {
        write(name, obj);
        bad({name}, "(it begins like OBJ)");
    }
    write("level.obj", "IWAD and so on");
    bad({"level.obj"}, "which viewer2d reads");
}

TEST_F(Viewer3d, ScenesOfAlmostNothingAreMeasured) {
    const auto expect_all_seen = [&](const std::string& obj, int triangles) {
        write("s.obj", obj);
        const Json s = stats({"s.obj", "--set", "reference_size=160x120", "--budget", "unlimited", "--shot", "s.svg",
                              "--do", "run; back; step; freeze; orbit 30,10; fit; unfreeze; run"});
        EXPECT_EQ(s["primitives"], triangles);
        EXPECT_EQ(s["coverage"], 1);
        EXPECT_GT(s["visible"], 0);
        EXPECT_EQ(s["unassigned"], 0);
    };
    const std::string one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    expect_all_seen(one, 1);
    std::string plane;
    for (int i = 0; i < 36; ++i) plane += "v " + std::to_string(i % 6) + " " + std::to_string(i / 6) + " 7\n";
    for (int i = 0; i < 29; ++i)
        if (i % 6 < 5)
            plane += "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 8) + "\n";
    expect_all_seen(plane, 25);
    // One as large as the scene, and one a thousand times as large as the rest.
    expect_all_seen(plane + "v 0 0 6\nv 6 0 8\nv 0 6 7\nf 37 38 39\n", 26);
    expect_all_seen(plane + "v -9000 -9000 6\nv 9000 0 8\nv 0 9000 7\nf 37 38 39\n", 26);
}

TEST_F(Viewer3d, AMillionVerticesAtOnePlaceAreNoTrouble) {
    // A third of a million triangles without area, and three that have one.
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1000009\nproperty float x\nproperty float y\n"
        "property float z\nelement face 333336\nproperty list uchar int vertex_indices\nend_header\n";
    const auto add = [&](const auto& value) { ply.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (int i = 0; i < 3000000; ++i) add(0.5f);
    for (int i = 0; i < 27; ++i) add(static_cast<float>(i * i % 7));
    for (std::int32_t i = 0; i < 333336; ++i) {
        ply += '\3';
        for (std::int32_t k = 0; k < 3; ++k) add(i < 333333 ? 3 * i + k : 1000000 + 3 * (i - 333333) + k);
    }
    write("same.ply", ply);
    const Result result = headless({"same.ply", "--set", "reference_size=64x48", "--stats", "s.json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("dropped 333333 of zero area"), std::string::npos) << result.err;
    const Json s = Json::parse(read("s.json"));
    EXPECT_EQ(s["primitives"], 3);
    EXPECT_LT(s["cells"], 10000);
}

TEST_F(Viewer3d, CamerasThatCannotBeAreRefused) {
    for (const char* bad_number : {"nan", "-inf", "1e999"}) {
        const std::string n = bad_number;
        bad({"bottleneck", "--eye", n + ",0,0"}, "point '" + n + ",0,0'");
        bad({"bottleneck", "--look-at", "0," + n + ",0"}, "point '0," + n + ",0'");
        bad({"bottleneck", "--do", "eye 0,0," + n}, "point '0,0," + n + "'");
        bad({"bottleneck", "--do", "step 3; walk 0,0," + n}, "walk");
    }
    bad({"bottleneck", "--fov", "nan"}, "--fov 'nan'");
    bad({"bottleneck", "--eye", "1,1,1", "--look-at", "1,1,1"}, "look-at coincides with the eye");
    bad({"bottleneck", "--fov", "180"}, "fov");
    bad({"bottleneck", "--fov", "0"}, "fov");
    bad({"bottleneck", "--do", "zoom 1e308; zoom 1e308"}, "zoom");
    good({"bottleneck", "--do", "step 5; freeze; orbit 10,0; save s.json; path test; path save p.json"});
    const Json state = Json::parse(read("s.json")), path = Json::parse(read("p.json"));
    for (const Json& value : {Json(), Json("nan")}) {
        for (const char* view : {"view", "display_view"}) {
            Json wrong = state;
            wrong[view]["eye"][1] = value;
            write("wrong.json", wrong.dump());
            bad({"--state", "wrong.json"}, std::string("wrong.json: /") + view + "/eye: ");
        }
        Json wrong = path;
        wrong["frames"][3]["look_at"][2] = value;
        write("wrong.json", wrong.dump());
        bad({"bottleneck", "--do", "path open wrong.json"}, "wrong.json: /frames/3/look_at/2: ");
    }
    for (const char* number : {"NaN", "1e999"}) {
        std::string text = read("p.json");
        text.replace(text.find("\"eye\": [") + 8, 0, number + std::string(", "));
        write("wrong.json", text);
        bad({"bottleneck", "--do", "path open wrong.json"}, "wrong.json: ");
    }
}

TEST_F(Viewer3d, AFullDiskIsNamedAndNothingElseHappens) {
    const auto fails = [&](const std::string& file, std::vector<std::string> arguments) {
        SCOPED_TRACE(file);
        fs::create_symlink("/dev/full", folder / file);
        const std::size_t before = files();
        arguments.insert(arguments.begin(), {"bottleneck", "--size", "200x150", "--set", "reference_size=64x48"});
        const Result result = headless(arguments);
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_EQ(result.err, "viewer3d: cannot write " + file + ": No space left on device\n");
        EXPECT_EQ(files(), before);
        fs::remove(folder / file);
    };
    for (const char* file : {"a.png", "a.svg", "a.pdf", "a.png.json"})
        fails(file, {"--shot", std::string(file).substr(0, 5)});
    fails("f-0002.png", {"--do", "run; film 1-3 f.png"});
    for (const char* file : {"f.pdf", "f.gif", "f.pdf.json"})
        fails(file, {"--do", "run; film 1-3 " + std::string(file).substr(0, 5)});
    fails("s.json", {"--stats", "s.json"});
    fails("t.json", {"--trace", "t.json"});
    fails("s.json", {"--do", "save s.json"});
    fails("p.json", {"--do", "path test; path save p.json"});
    fails("w.txt", {"--do", "panels w.txt"});
}

TEST_F(Viewer3d, WhatADiskHeldBeforeItWasFullIsStillThere) {
    for (const char* file : {"a.png", "a.png.json", "p.json"}) write(file, "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{512, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);  // the viewer inherits it
    const Result shot = headless({"bottleneck", "--shot", "a.png"});
    const Result path = headless({"bottleneck", "--do", "path test; path save p.json"});
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    for (const Result& result : {shot, path}) {
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_EQ(result.error_lines(), 1u) << result.err;
        EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
    }
    for (const char* file : {"a.png", "a.png.json", "p.json"}) EXPECT_EQ(read(file), "old") << file;
    EXPECT_EQ(files(), 3u);
}

TEST_F(Viewer3d, ADriverThatIsTooOldIsNamedWithWhatToInstall) {
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    setenv("MESA_GLSL_VERSION_OVERRIDE", "120", 1);
    const Result result = headless({"bottleneck", "--shot", "a.png"});
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    if (result.status == 0) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(result.error_lines(), 2u) << result.err;
    EXPECT_EQ(result.err.find("warning: the reference is drawn in software"), 0u) << result.err;
    EXPECT_NE(result.err.find("\nviewer3d: OpenGL 3.3 is needed; found: OpenGL 2.1"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("libgl1-mesa-dri"), std::string::npos) << result.err;
    EXPECT_EQ(files(), 0u);
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
