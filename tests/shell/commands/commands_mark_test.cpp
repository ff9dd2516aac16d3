// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, select) {
    run("select 7");
    EXPECT_EQ(session().selected_cell, 7u);
    run("select none");
    EXPECT_EQ(session().selected_cell, none);
    run("method coorg-teller; step 3; select node:last");
    EXPECT_EQ(session().selected_node, session().timeline().steps[session().position() - 1].item.id);
    run("select primitive:4");
    EXPECT_NE(session().selected_node, none) << "the box that is being explained stays";
    run("select 7");
    EXPECT_EQ(session().selected_node, none);
    run("method published; run; select object:" + session().objects().names[0]);
    ASSERT_NE(session().selected_primitive, none);
    EXPECT_EQ(session().objects().of[session().selected_primitive], 0u);
    run("select object:#1");
    EXPECT_EQ(session().objects().of[session().selected_primitive], 1u);
    EXPECT_THROW(run("select object:no such"), InputError);
    EXPECT_THROW(run("select pixel:1,1"), InputError) << "there is none in 2D";
}

TEST_F(EachCommand, bookmark) {
    run("bookmark the tenth step; seek 3; seek @the tenth step");
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(session().bookmarks, (std::vector<Bookmark>{{10, "the tenth step"}}));
}

TEST_F(EachCommand, break) {
    run("break step:12; break rho > 1e9");
    EXPECT_EQ(session().breakpoints.size(), 2u);
    run("break rho > 1e9");
    EXPECT_EQ(session().breakpoints, (std::vector<Breakpoint>{{"step:12", true}}));
}

TEST_F(EachCommand, break_switch) {
    run("break step:12; break-switch 1; continue");
    EXPECT_TRUE(session().finished());
    run("break none");
    EXPECT_TRUE(session().breakpoints.empty());
}

TEST_F(EachCommand, mark) {
    run("mark visible_share == 0");
    EXPECT_FALSE(bench->marked.empty());
    const std::uint32_t first = bench->marked.front();
    EXPECT_THROW(run("mark rho >"), InputError);
    EXPECT_EQ(bench->marked.front(), first) << "marks stay where the new condition is none";
    run("seek 0; until visible_share == 0");
    EXPECT_EQ(session().position(), first);
    run("mark none");
    EXPECT_TRUE(bench->marked.empty());
}

}  // namespace
}  // namespace sightline
