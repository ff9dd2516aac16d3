// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/desk/moves.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, scenes) { flips("scenes", bench->desk.chooser); }

TEST_F(EachCommand, show) {
    run("show front");
    EXPECT_EQ(bench->desk.right, "front");
    run("show front");
    EXPECT_EQ(bench->desk.right, "");
    flips("show timeline", bench->desk.timeline);
}

TEST_F(EachCommand, tool) {
    run("tool ring");
    EXPECT_EQ(bench->desk.tool, Tool::ring);
}

TEST_F(EachCommand, axis) {
    run("axis primitives");
    EXPECT_EQ(bench->desk.axis, TimelineAxis::primitives);
}

TEST_F(EachCommand, zoom_timeline) {
    const double steps = whole_run(*bench);
    ASSERT_GT(steps, 40);
    run("zoom-timeline 10-40");
    EXPECT_EQ(bench->desk.timeline_from, 10 / steps);
    EXPECT_EQ(bench->desk.timeline_to, 40 / steps);
    run("zoom-timeline 20-999999");
    EXPECT_EQ(bench->desk.timeline_from, 20 / steps);
    EXPECT_EQ(bench->desk.timeline_to, 1);
    for (const char* wrong : {"", "3", "7-7", "9-3", "-", "a-b", "999999-9999999"})
        EXPECT_THROW(run(std::string("zoom-timeline ") + wrong), InputError) << wrong;
    EXPECT_EQ(bench->desk.timeline_from, 20 / steps);
    run("zoom-timeline all");
    EXPECT_EQ(bench->desk.timeline_from, 0);
    EXPECT_EQ(bench->desk.timeline_to, 1);
}

TEST_F(EachCommand, projector) { flips("projector", bench->desk.projector); }

TEST_F(EachCommand, animate) { flips("animate", bench->desk.animate); }

TEST_F(EachCommand, fullscreen) { flips("fullscreen", bench->desk.fullscreen); }

TEST_F(EachCommand, scale) {
    run("scale 2; scale up");
    EXPECT_EQ(bench->desk.scale, 2.25);
}

TEST_F(EachCommand, console) { flips("console", bench->desk.console); }

TEST_F(EachCommand, help) { flips("help", bench->desk.help); }

}  // namespace
}  // namespace sightline
