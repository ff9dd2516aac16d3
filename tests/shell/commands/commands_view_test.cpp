// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/draw/shown_world.h"
#include "shell/desk/fly.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, eye) {
    run("eye 8,2");
    EXPECT_EQ(session().culling_view().eye, Vec<2>(8, 2));
}

TEST_F(EachCommand, look) {
    run("look 8.5,7");
    EXPECT_EQ(session().culling_view().look_at, Vec<2>(8.5, 7));
    run("select primitive:4; look selected");
    const auto& [a, b] = session().scene().primitives[4];
    EXPECT_NEAR(glm::length(session().culling_view().look_at - (a + b) * 0.5), 0, 1e-12);
    run("select none");
    EXPECT_THROW(run("look selected"), InputError) << "a point is what it takes then";
}

TEST_F(EachCommand, fov) {
    run("fov 75");
    EXPECT_EQ(session().culling_view().fov, 75);
    EXPECT_EQ(session().position(), 10u) << "a moved view keeps the step";
}

TEST_F(EachCommand, fit) {
    run("set zoom=3; set zoom_at=point; set zoom_x=7; fit");
    EXPECT_EQ(session().settings().zoom, 1);
    EXPECT_EQ(session().settings().zoom_at, ZoomAt::view);
    EXPECT_THROW(run("fit selected"), InputError) << "nothing is selected";
    run("select primitive:4; fit selected");
    const auto& [a, b] = session().scene().primitives[4];
    EXPECT_NEAR(glm::length(shown_world(session()).centre() - (a + b) * 0.5), 0, 1e-9);
    for (const Vec<2>& end : {a, b}) {
        EXPECT_TRUE(shown_world(session()).min.x <= end.x && end.x <= shown_world(session()).max.x);
        EXPECT_TRUE(shown_world(session()).min.y <= end.y && end.y <= shown_world(session()).max.y);
    }
}

TEST_F(EachCommand, path) {
    EXPECT_THROW(run("path play"), InputError) << "there is none";
    run("path record");
    const ViewSpec<2> first = session().culling_view();
    for (const char* eye : {"eye 4,5", "eye 5,5", "eye 6,5"}) {
        run(eye);
        advance_flight(*bench, 1.0 / path_frames_per_second);
    }
    run("path record");
    const FlightPath<2> path = bench->flight.path;
    ASSERT_EQ(path.frames.size(), 4u);
    EXPECT_EQ(path.frames[0], first);
    EXPECT_EQ(path.frames[3].eye, Vec<2>(6, 5));
    run("path frame 1");
    EXPECT_EQ(session().culling_view(), path.frames[1]);
    EXPECT_FALSE(session().flying()) << "a frame that stands can be stepped through";
    const std::string file = (std::filesystem::temp_directory_path() / "sightline-path-2d.json").string();
    run("path save " + file + "; path record; path record; path open " + file);
    EXPECT_EQ(bench->flight.path, path);
    EXPECT_EQ(said.back().find("made for"), std::string::npos) << "nothing is said of a path of this scene";
    FlightPath<2> elsewhere = path;
    elsewhere.scene = "rooms";
    write_file(file, write_path(elsewhere));
    run("path open " + file);
    EXPECT_EQ(said.front(), "this path was made for rooms, not for bottleneck");
    std::filesystem::remove(file);
    run("path start; path play");
    while (advance_flight(*bench, 1)) {
    }
    EXPECT_EQ(session().culling_view(), path.frames[3]);
    EXPECT_FALSE(session().flying());
}

TEST_F(EachCommand, zoom) {
    const Box<2> before = shown_world(session());
    run("zoom 2");
    const Box<2> after = shown_world(session());
    EXPECT_NEAR(before.extent().x, 2 * after.extent().x, 1e-9);
    EXPECT_NEAR(glm::length(before.centre() - after.centre()), 0, 1e-9);
    run("undo");
    EXPECT_EQ(session().settings().zoom, 1);
    run("zoom 1e9; zoom 1e-30; zoom 1e9");
}

TEST_F(EachCommand, pan) {
    const Box<2> before = shown_world(session());
    run("pan 0.5,-0.25");
    const Box<2> after = shown_world(session());
    EXPECT_NEAR(after.min.x, before.min.x + before.extent().x / 2, 1e-9);
    EXPECT_NEAR(after.min.y, before.min.y - before.extent().y / 4, 1e-9);
}

TEST_F(EachCommand, freeze) {
    const ViewSpec<2> view = session().culling_view();
    const std::uint64_t hash = session().hash();
    run("freeze; eye 1,1; look 2,2; fov 30");
    EXPECT_TRUE(session().frozen());
    EXPECT_EQ(session().culling_view(), view);
    EXPECT_EQ(session().display_view(), (ViewSpec<2>{{1, 1}, {2, 2}, 30}));
    EXPECT_EQ(session().hash(), hash);
}

TEST_F(EachCommand, unfreeze) {
    run("freeze; eye 1,1");
    EXPECT_NE(session().display_view(), session().culling_view());
    run("unfreeze");
    EXPECT_FALSE(session().frozen());
    EXPECT_EQ(session().display_view(), session().culling_view());
}

TEST_F(EachCommand, eye_strip) {
    run("eye-strip");
    EXPECT_EQ(session().settings().show_eye, Switch::on);
    run("eye-strip");
    EXPECT_EQ(session().settings().show_eye, Switch::off);
    run("eye-strip; undo");
    EXPECT_EQ(session().settings().show_eye, Switch::off);
}

}  // namespace
}  // namespace sightline
