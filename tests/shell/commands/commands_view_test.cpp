// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_world.h"
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
