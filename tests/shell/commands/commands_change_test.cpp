// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/methods/cplp/cplp.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/session/settings_table.h"
#include "tests/scene/scene_support.h"
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
    run("preset prototype-2d");
    EXPECT_EQ(session().settings().parameters.text(view_vector_row()), "camera");
    run("preset default");
    EXPECT_EQ(session().settings().parameters.text(view_vector_row()), "eye");
}

/// Commands of an earlier version (1: 6bcb33f) do what they did.
class OldCommands : public EachCommand {};

TEST_F(OldCommands, StillRun) {
    Settings expected = session().settings();
    for (const char* assignment :
         {"view_vector=camera", "transfer_sign=signed", "star_shaped=off", "outside_view=enqueue",
          "neighbours_before_break=no", "border=none", "error_bound=0.05"})
        apply_setting(expected, assignment);
    std::string old = read_file(SIGHTLINE_SOURCE_DIR "/tests/files/commands_1.txt");
    old.pop_back();  // the end of the line
    run(old);
    EXPECT_EQ(session().settings(), expected) << "what the preset letter came to";
    ASSERT_TRUE(bench->other);
    EXPECT_EQ(bench->other->session.settings(), expected);
}

TEST_F(EachCommand, complete) {
    run("method layers; budget 10%; run; seek 12");
    const std::uint64_t hash = session().hash();
    const std::uint32_t rendered = session().counters().rendered_count, steps = session().recorded();
    run("complete");
    EXPECT_EQ(session().method().id, "cplp");
    EXPECT_EQ(session().settings().parameters.text(cplp_first_row()), "layers");
    EXPECT_EQ(session().counters().rendered_count, rendered) << "it stands where it stood";
    run("step");
    EXPECT_EQ(session().timeline().steps[session().position() - 1].item.kind, Kind::round);
    run("run");
    EXPECT_EQ(session().guarantee(), "conservative at this resolution");
    run("complete");
    EXPECT_EQ(session().method().id, "layers");
    EXPECT_EQ(session().settings().budget, parse_budget("10%"));
    EXPECT_EQ(session().counters().rendered_count, rendered);
    run("seek 12");
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(session().recorded(), steps);
    run("seek end; complete");
    EXPECT_EQ(session().settings().budget, parse_budget("10%")) << "it had come to its budget";
    run("undo");
    EXPECT_EQ(session().method().id, "layers");
    EXPECT_THROW(run("method everything; complete"), InputError);
    for (const char* method : {"tri", "tri-seen", "extinction"}) {
        run("method " + std::string(method));
        test::expect_input_error([&] { run("complete"); },
                                 "command 'complete': '" + std::string(method) +
                                     "' cannot be completed: rounds of cPLP go on from methods that render whole "
                                     "cells: published, layers, formula, flux");
        EXPECT_EQ(session().method().id, method);
    }
    // Also behind steps that rendered nothing new, which the rounds do not wait for.
    run("method flux; budget unlimited; run");
    int behind = 0;
    for (std::uint32_t step = session().recorded(); step > 0; --step) {
        run("seek " + std::to_string(step));
        const std::uint64_t here = session().hash();
        run("complete");
        behind += session().position() < step;
        run("complete");
        ASSERT_EQ(session().position(), step);
        ASSERT_EQ(session().hash(), here);
    }
    EXPECT_GT(behind, 0);
    run("seek 12; complete; back 4; complete");
    EXPECT_LT(session().position(), 12u) << "it was left by hand";
}

TEST_F(EachCommand, method) {
    run("method centroid");
    EXPECT_EQ(session().method().id, "centroid");
}

TEST_F(EachCommand, budget) {
    run("budget 5%; run");
    EXPECT_EQ(bench->last_stop, Stop::budget);
    EXPECT_EQ(budget_text(session().settings().budget), "5%");
    test::expect_input_error([&] { run("budget wrong:0.5%"); },
                             "command 'budget wrong:0.5%': setting budget: budget 'wrong:0.5%': only lab measure follows wrong pixels");
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
