// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/session/state_file.h"
#include "shell/desk/moves.h"
#include "shell/panels/panel.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, compare) {
    run("compare centroid");
    EXPECT_EQ(other().session.method().id, "centroid");
    EXPECT_EQ(other().session.position(), 10u);
    EXPECT_EQ(session().method().id, "published");
    run("compare distance");
    EXPECT_EQ(other().session.method().id, "centroid") << "an alias";
    run("compare published on_reenqueue=min");
    EXPECT_EQ(other().session.settings().parameters.text(on_reenqueue_row()), "min");
    EXPECT_EQ(session().settings().parameters.text(on_reenqueue_row()), "replace");
    run("compare jitter=0.25,penalty=none");
    EXPECT_EQ(other().session.settings().jitter, 0.25);
    EXPECT_EQ(other().session.settings().parameters.text(penalty_row()), "none");
    run("compare preset:paper-3d");
    EXPECT_EQ(other().session.settings().parameters.text(view_vector_row()), "camera");
    EXPECT_EQ(difference(session().settings(), other().session.settings()), Invalidates::traversal) << "the same cells";
    run("compare streets");
    EXPECT_EQ(other().session.scene().id, "streets");
    run("set jitter=0.1; save " + file("right.json") + "; undo; compare " + file("right.json"));
    EXPECT_EQ(other().session.settings().jitter, 0.1);
    EXPECT_EQ(other().session.shared_scene(), session().shared_scene());
    run("compare same");
    EXPECT_EQ(other().session.settings(), session().settings());
    run("shot " + file("pair.svg") + "; compare off");
    EXPECT_FALSE(bench->other);
    EXPECT_TRUE(open_state(read_file(file("pair.svg.json")), "f").other.has_value());
}

TEST_F(EachCommand, align) {
    run("compare centroid; align rendered; seek 6");
    EXPECT_EQ(other().align, Align::rendered);
    EXPECT_GE(other().session.counters().rendered_count, session().counters().rendered_count);
    EXPECT_NE(other().session.position(), 6u);
    const auto aligned = [&] {  // the line of the panel that says so
        std::string begins;
        for (const Row& row : find_panel<2>("compare")->rows(*bench))
            if (row.text.ends_with("(aligned)")) begins += row.text.substr(0, row.text.find(':'));
        return begins;
    };
    EXPECT_EQ(aligned(), "rendered");
    run("align step");
    EXPECT_EQ(aligned(), "step");
    EXPECT_EQ(other().session.position(), 6u);
}

TEST_F(EachCommand, difference) {
    run("compare centroid; difference");
    const auto step = first_difference(at_the_end(session()), at_the_end(other().session));
    ASSERT_TRUE(step);
    EXPECT_EQ(session().position(), *step);
    EXPECT_EQ(other().session.position(), *step);
    EXPECT_EQ(said.at(0).find("Step " + std::to_string(*step) + ": left projects"), 0u);
    run("seek 10; compare same; difference");
    EXPECT_EQ(said.at(0).find("Both agree to the end"), 0u);
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, swap) {
    run("compare centroid; swap");
    EXPECT_EQ(session().method().id, "centroid");
    EXPECT_EQ(other().session.method().id, "published");
    run("swap");
    EXPECT_EQ(session().method().id, "published");
}

}  // namespace
}  // namespace sightline
