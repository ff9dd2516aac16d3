// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/plp/plp_parameters.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, set) {
    run("set palette=print");
    EXPECT_EQ(session().settings().palette, Palette::print);
    EXPECT_TRUE(said.empty()) << "nothing was run again";
    run("set penalty=add");
    EXPECT_EQ(session().settings().parameters.text(penalty_row()), "add");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].find("step 10 of "), 0u) << said[0];
    run("set error_bound=0.5");
    EXPECT_NE(said.at(0).find("new cells: "), std::string::npos) << said[0];
}

TEST_F(EachCommand, cycle) {
    const std::string before(session().settings().parameters.text(penalty_row()));
    for (int i = 0; i < 3; ++i) {
        run("cycle penalty");
        EXPECT_EQ(session().settings().parameters.text(penalty_row()) == before, i == 2);
    }
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, preset) {
    run("preset letter");
    EXPECT_EQ(session().settings().parameters.text(view_vector_row()), "camera");
    run("preset default");
    EXPECT_EQ(session().settings().parameters.text(view_vector_row()), "eye");
}

TEST_F(EachCommand, method) {
    run("method centroid");
    EXPECT_EQ(session().method().id, "centroid");
}

TEST_F(EachCommand, budget) {
    run("budget 5%; run");
    EXPECT_EQ(bench->last_stop, Stop::budget);
    EXPECT_EQ(budget_text(session().settings().budget), "5%");
}

TEST_F(EachCommand, undo) {
    const Settings before = session().settings();
    run("set jitter=0.1; undo");
    EXPECT_EQ(session().settings(), before);
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, redo) {
    run("set jitter=0.1; undo; redo");
    EXPECT_EQ(session().settings().jitter, 0.1);
}

}  // namespace
}  // namespace sightline
