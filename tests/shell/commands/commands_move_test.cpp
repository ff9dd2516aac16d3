// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/substep.h"
#include "shell/desk/play.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, step) {
    run("seek 0; step");
    EXPECT_EQ(session().position(), 1u);
    run("step 9");
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(bench->last_stop, Stop::steps);
}

TEST_F(EachCommand, frame) {
    test::expect_input_error([&] { run("frame keep"); },
                             "command 'frame keep': this method does not look at the frame before");
    run("method coorg-teller");
    test::expect_input_error([&] { run("frame 0"); },
                             "command 'frame 0': there are no frames: fly, or keep one with `frame keep`");
    const ViewSpec<2> before = session().culling_view();
    run("frame keep; eye 1,1");
    EXPECT_EQ(session().lane(), std::vector{before});
    const ViewSpec<2> after = session().culling_view();
    run("frame 0");
    EXPECT_EQ(session().culling_view(), before);
    EXPECT_TRUE(session().lane().empty());
    run("frame 1");
    EXPECT_EQ(session().culling_view(), after);
    run("frame none");
    EXPECT_TRUE(session().lane().empty());
    EXPECT_EQ(session().culling_view(), after);
}

TEST_F(EachCommand, back) {
    run("back; back 4");
    EXPECT_EQ(session().position(), 5u);
    run("back 100");
    EXPECT_EQ(session().position(), 0u);
}

TEST_F(EachCommand, into) {
    run("into");
    EXPECT_EQ(session().position(), 11u);
    EXPECT_EQ(bench->substep, 0u);
    run("into");
    EXPECT_EQ(bench->substep, 1u);
    run("step");
    EXPECT_EQ(session().position(), 11u) << "it completes the step";
    EXPECT_EQ(bench->substep, std::nullopt);
}

TEST_F(EachCommand, out) {
    run("out");
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(bench->substep, substep_count(session(), 10) - 2) << "the last one is taken back";
    run("seek 10; into; into; out; out");
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(bench->substep, std::nullopt);
}

TEST_F(EachCommand, seek) {
    const std::uint32_t end = session().recorded();
    run("seek start");
    EXPECT_EQ(session().position(), 0u);
    run("seek end");
    EXPECT_EQ(session().position(), end);
    run("seek 999999");
    EXPECT_EQ(session().position(), end);
    EXPECT_EQ(bench->last_stop, Stop::front_empty);
    run("seek 10");
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(bench->last_stop, Stop::steps);
}

TEST_F(EachCommand, run) {
    run("seek 0; run");
    EXPECT_EQ(bench->last_stop, Stop::front_empty);
    EXPECT_EQ(session().recorded(), session().position());
    EXPECT_GT(session().position(), 50u);
}

TEST_F(EachCommand, until) {
    run("until step:20");
    EXPECT_EQ(session().position(), 20u);
    EXPECT_EQ(bench->last_stop, Stop::breakpoint);
    run("seek 10; until rendered_now > 0 && step > 11");
    EXPECT_GT(session().position(), 11u);
}

TEST_F(EachCommand, reach) {
    const std::uint32_t cell = session().timeline().steps[3].item.id;
    run("reach " + std::to_string(cell));
    EXPECT_EQ(session().position(), 4u);
    run("seek 0; select " + std::to_string(cell) + "; reach selected");
    EXPECT_EQ(session().position(), 4u);
    Session<2> end = session();
    end.run();
    for (std::uint32_t c = 0; c < end.cells().cell_count(); ++c)
        if (end.mark(c).state != CellState::projected) {
            run("reach " + std::to_string(c));
            EXPECT_NE(said.back().find("never projected"), std::string::npos);
            EXPECT_EQ(session().position(), 4u) << "it stays";
            break;
        }
}

TEST_F(EachCommand, continue) {
    run("break step:12; continue");
    EXPECT_EQ(session().position(), 12u);
    EXPECT_EQ(bench->last_stop, Stop::breakpoint);
    run("continue");
    EXPECT_TRUE(session().finished());
    EXPECT_NE(said.back().find("no breakpoint"), std::string::npos);
}

TEST_F(EachCommand, play) {
    run("play");
    advance_clock(*bench, 0.25);
    EXPECT_EQ(session().position(), 10u) << "half a step is due";
    advance_clock(*bench, 0.25);
    EXPECT_EQ(session().position(), 11u);
    run("play 20s");
    EXPECT_DOUBLE_EQ(bench->transport.steps_per_second, session().recorded() / 20.0);
}

TEST_F(EachCommand, pause) {
    run("play; pause");
    EXPECT_EQ(transport_state(*bench), TransportState::paused);
}

TEST_F(EachCommand, toggle) {
    run("toggle");
    EXPECT_EQ(transport_state(*bench), TransportState::playing);
    run("toggle");
    EXPECT_EQ(transport_state(*bench), TransportState::paused);
}

TEST_F(EachCommand, speed) {
    run("speed 2; speed half");
    EXPECT_EQ(bench->transport.steps_per_second, 1);
    run("speed double; speed double");
    EXPECT_EQ(bench->transport.steps_per_second, 4);
}

}  // namespace
}  // namespace sightline
