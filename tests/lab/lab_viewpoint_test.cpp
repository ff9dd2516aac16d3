// What `lab viewpoint` measures: where eyes are, claims judged on walks made by hand, and the command with its page.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "core/base/file.h"
#include "core/methods/by_viewpoint/by_viewpoint.h"
#include "core/methods/method_table.h"
#include "core/scene/read/load.h"
#include "core/scene/scene_view.h"
#include "lab/viewpoint/viewpoint_report.h"
#include "tests/lab/run_lab.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;

/// Techniques view, shadow-frusta, hom, portals; a frame inside, one on the ground, one above.
struct ByHand {
    std::shared_ptr<const Scene<3>> scene = std::make_shared<const Scene<3>>(load_scene<3>("soda"));
    CellComplex<3> cells;
    ViewpointResults results;

    ByHand() {
        const Variant<3> variant =
            make_variant<3>(method_table<3>(), "by-viewpoint techniques='view; shadow-frusta; hom; portals'");
        cells.boxes->of(*scene);
        Services services;
        services.image = {64, 48};
        const View<3> view = scene_view(*scene->start_view, *scene, {64, 48});
        ViewpointScene& one = results.scenes.emplace_back();
        one.scene = "soda";
        one.path = "walk";
        one.table = viewpoint_table<3>(method_table<3>(),
                                       {scene.get(), &cells, view, none, variant.parameters, nullptr, services});
        one.walk.look_up_ns = 100;
        add(EyePlace::inside, {40, 30, 30, 2}, 2);
        add(EyePlace::street, {60, 10, 20, 60}, 10);
        add(EyePlace::above, {50, 49, 30, 50}, 30);
    }
    void add(EyePlace where, const std::vector<double>& alone, double adaptive) {
        WalkFrame& frame = results.scenes.back().walk.frames.emplace_back();
        frame.where = where;
        for (const double ms : alone) frame.alone.push_back({ms / 2, ms / 2, 7, 0});
        frame.adaptive = {0, adaptive, 7, 0};
        frame.everything = {0, 300, 1000, 0};
    }
    std::vector<WalkFrame>& frames() { return results.scenes.back().walk.frames; }
    std::string judged(const std::string& words) const {
        for (const Claim& claim : viewpoint_claims(results))
            if (claim.text.find(words) != std::string::npos) return verdict_text(claim);
        return "not judged";
    }
};

TEST(ViewpointWalk, AddsUpByPlace) {
    const ByHand made;
    const ViewpointWalk& walk = made.results.scenes.back().walk;
    EXPECT_DOUBLE_EQ(walk.adaptive_ms(), 14);
    EXPECT_DOUBLE_EQ(walk.hindsight_ms(), 14);
    EXPECT_DOUBLE_EQ(walk.alone_ms(0), 50);
    EXPECT_EQ(walk.best_alone(), 2u) << "26.7 ms against 29.7";
    EXPECT_EQ(walk.frames_at(EyePlace::street), 1u);
    EXPECT_DOUBLE_EQ(walk.mean_at(EyePlace::above, [](const WalkFrame& f) { return f.alone[0].ms(); }), 50);
    EXPECT_EQ(walk.frames[1].best(), 1u);
}

TEST(ViewpointClaims, AreJudgedByTheShapeOfTheWalk) {
    ByHand made;
    EXPECT_EQ(made.judged("All of it is drawn"), "holds") << "300 / 60";
    EXPECT_EQ(made.judged("In rooms"), "holds") << "60 / 2";
    EXPECT_EQ(made.judged("Near the ground"), "holds") << "60 / 10";
    EXPECT_EQ(made.judged("above the roofs"), "holds") << "50 / 49";
    EXPECT_EQ(made.judged("occlusion maps"), "holds");
    EXPECT_EQ(made.judged("No technique"), "holds");
    EXPECT_EQ(made.judged("Choosing pays"), "holds") << "14 against 26.7";
    made.frames()[0].adaptive.draw_ms = 5;
    EXPECT_EQ(made.judged("In rooms"), "does not hold") << "60 / 5 < 15";
    made.frames()[1].alone[1].draw_ms = 20;
    EXPECT_EQ(made.judged("Near the ground"), "does not hold") << "60 / 25 < 5";
    made.frames()[2].alone[1].draw_ms = 5;
    EXPECT_EQ(made.judged("above the roofs"), "does not hold") << "50 / 29.5";
    made.frames()[2].alone[2].draw_ms = 60;
    EXPECT_EQ(made.judged("occlusion maps"), "does not hold");
    for (WalkFrame& frame : made.frames()) frame.alone[3] = {0, 1, 7, 0};
    EXPECT_EQ(made.judged("No technique"), "does not hold");
    EXPECT_EQ(made.judged("Choosing pays"), "does not hold");
    made.frames().erase(made.frames().begin());
    EXPECT_EQ(made.judged("In rooms"), "not judged");
}

TEST(EyePlace, IsARoomTheGroundOrAboveAll) {
    const Scene<3> scene = load_scene<3>("soda");
    double top = -INFINITY;
    for (const Primitive<3>& primitive : scene.primitives)
        for (const Vec<3>& vertex : primitive) top = std::max(top, vertex[scene.up_axis]);
    Vec<3> eye = middle_of(scene.rooms.all.front());
    EXPECT_EQ(eye_place(scene, eye), EyePlace::inside);
    eye[scene.up_axis] = top + 1;
    EXPECT_EQ(eye_place(scene, eye), EyePlace::above);
    eye = Vec<3>(1e4);
    eye[scene.up_axis] = top - 0.5;
    EXPECT_EQ(eye_place(scene, eye), EyePlace::street);
}

TEST(ViewpointCommand, WritesItsPageAndNamesWhatIsWrong) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-viewpoint-" + std::to_string(getpid()));
    const auto lab = [](const std::vector<std::string>& words) { return test::run_lab("viewpoint", words); };
    const auto [status, said] =
        lab({"soda@walk", "--frames", "2", "--repeats", "1", "--fit-views", "2", "--image", "64x48", "--fill",
             "--sizes", "--method", "by-viewpoint techniques='view; portals; levels' grid=1 samples=1 azimuths=3",
             "--out", folder.string(), "--markdown", (folder / "page.md").string()});
    EXPECT_EQ(status, 0) << said;
    EXPECT_NE(said.find("soda, path walk, 2 frames"), std::string::npos) << said;
    EXPECT_NE(said.find("16 × 7 and two caps"), std::string::npos) << said;
    const std::string page = read_file(folder / "page.md");
    for (const char* const part :
         {"| by viewpoint |", "| levels |", "| everything |", "Choosing pays",
          "![Bytes of the table by its intervals](images/results-viewpoint-soda-walk-sizes.svg)",
          "./run lab viewpoint soda@walk --frames 2"})
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
    EXPECT_TRUE(fs::exists(folder / "images/results-viewpoint-soda-walk.svg"));
    const std::string csv = read_file(folder / "soda-walk.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    EXPECT_NE(csv.find("\n0,inside,"), std::string::npos) << csv;
    fs::remove_all(folder);
    const auto complains = [&](const std::vector<std::string>& words, const std::string& of) {
        const auto [failed, text] = lab(words);
        EXPECT_EQ(failed, 2);
        EXPECT_NE(text.find(of), std::string::npos) << text;
    };
    complains({"soda", "--method", "view"}, "is not by-viewpoint");
    complains({"soda", "--path", "moon"}, "moon");
    complains({"soda", "campus", "--table", "t.json"}, "a table is of one scene");
    complains({"nowhere"}, "nowhere");
    complains({"2d:rooms"}, "is 2D");
    complains({"soda", "--frames", "-1"}, "--frames");
}

}  // namespace
}  // namespace sightline::lab
