// Paths on the bench: replayed, recorded, stepped, with one session and with two.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/session/pops.h"
#include "shell/commands/command_table.h"
#include "shell/desk/complete.h"
#include "shell/desk/fly.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

using namespace test;

constexpr double tick = 1 / path_frames_per_second;

class FlightPaths : public ::testing::Test {
protected:
    FlightPaths() {
        Random random(4711);
        Start3 start = random_start_3d(random);
        while (start.scene->primitives.size() < 30) start = random_start_3d(random);
        start.settings.method = "published";
        start.settings.budget = {Budget::Kind::primitives, 12};
        Scene<3> scene = *start.scene;
        FlightPath<3> path{"round", {}, {}, {}};
        for (int i = 0; i < 6; ++i) path.frames.push_back(random_view_3d(random));
        scene.paths = {path};
        start.scene = std::make_shared<const Scene<3>>(std::move(scene));
        bench.reset(new Workbench<3>{start.session()});
        bench->say = [](const std::string&) {};
    }
    void run(const std::string& text) { run_commands(*bench, text); }
    /// What a session that stands there would have.
    std::uint64_t expected(const Session<3>& like, std::uint32_t frame) const {
        Session<3> session = like;
        session.set_culling_view(like.scene().paths[0].frames[frame]);
        session.run();
        return session.hash();
    }
    std::unique_ptr<Workbench<3>> bench;
};

TEST_F(FlightPaths, WhereTheEyeRestsThePictureIsCompletedUntilItMovesOn) {
    run("method layers; path round; fly on; path frame 1");
    EXPECT_FALSE(complete_at_rest(*bench)) << "nobody asked for it";
    const std::size_t undos = bench->history.past.size();
    run("complete");
    for (const std::uint32_t frame : {1u, 4u, 2u}) {
        go_to_frame(*bench, frame);
        const std::uint64_t alone = bench->session.hash();
        EXPECT_EQ(bench->session.method().id, "layers");
        EXPECT_EQ(bench->session.settings().budget, parse_budget("12"));
        EXPECT_EQ(bench->session.hash(), expected(bench->session, frame));
        const std::uint32_t met = bench->session.counters().touched_count;
        ASSERT_TRUE(complete_at_rest(*bench));
        EXPECT_FALSE(complete_at_rest(*bench)) << "once";
        EXPECT_TRUE(bench->session.flying());
        EXPECT_EQ(bench->session.guarantee(), "conservative at this resolution");
        const Session<3>& session = bench->session;
        EXPECT_GE(session.traversal().met_before_completing(), met);
        for (std::uint32_t triangle = 0; triangle < session.scene().primitives.size(); ++triangle)
            EXPECT_TRUE(!session.reference().visible[triangle] || session.traversal().drawn().has(triangle))
                << triangle;
        EXPECT_NE(session.hash(), alone);
    }
    EXPECT_LE(bench->history.past.size(), undos + 1) << "one flight, one entry";
    run("complete");
    EXPECT_EQ(bench->session.method().id, "layers") << "and now stays alone";
    EXPECT_FALSE(complete_at_rest(*bench));
    run("complete");
    ASSERT_TRUE(complete_at_rest(*bench));
    run("fly off");
    EXPECT_EQ(bench->session.method().id, "cplp") << "what was seen can be stepped through";
    EXPECT_EQ(bench->session.guarantee(), "conservative at this resolution");
    run("complete");
    EXPECT_EQ(bench->session.method().id, "layers");
    EXPECT_EQ(bench->session.settings().budget, parse_budget("12"));
    EXPECT_EQ(bench->session.hash(), expected(bench->session, 2));
}

TEST_F(FlightPaths, ReplayingGoesThroughEveryFrameInBothSessionsWhileSettingsChange) {
    run("path round; compare centroid; path play");
    EXPECT_TRUE(bench->flight.bar);
    for (std::uint32_t frame = 1; frame < 6; ++frame) {
        EXPECT_TRUE(advance_flight(*bench, 10));  // a slow machine leaves none out
        EXPECT_EQ(bench->flight.frame, frame);
        EXPECT_TRUE(bench->session.flying());
        EXPECT_EQ(bench->session.hash(), expected(bench->session, frame));
        EXPECT_EQ(bench->other->session.hash(), expected(bench->other->session, frame));
        if (frame == 2) run("method layers");
        if (frame == 3) run("budget 7");
        if (frame == 4) run("set shrink=0.5");
        EXPECT_TRUE(bench->flight.replaying);
        EXPECT_TRUE(bench->session.flying()) << "the settings of frame " << frame << " ended it";
        EXPECT_EQ(bench->session.hash(), expected(bench->session, frame));
    }
    EXPECT_EQ(bench->session.settings().method, "layers");
    EXPECT_EQ(bench->session.counters().rendered_count, 7u);
    EXPECT_EQ(bench->other->session.settings().method, "centroid");
    EXPECT_EQ(bench->other->session.settings().shrink, 0.5) << "both are looked at in the same way";
    advance_flight(*bench, tick);
    EXPECT_FALSE(bench->flight.replaying) << "it stops at its end";
    EXPECT_FALSE(bench->session.flying());
    EXPECT_FALSE(bench->other->session.flying());
    EXPECT_EQ(bench->session.hash(), expected(bench->session, 5));
    run("path loop; path play");  // from the beginning again
    EXPECT_EQ(bench->flight.frame, 0u);
    for (int i = 0; i < 8; ++i) advance_flight(*bench, tick * 1.001);
    EXPECT_EQ(bench->flight.frame, 2u);
    EXPECT_TRUE(bench->flight.replaying);
}

TEST_F(FlightPaths, TheClockPaysForFrames) {
    run("path round; path play");
    EXPECT_FALSE(advance_flight(*bench, tick * 0.4));
    EXPECT_FALSE(advance_flight(*bench, tick * 0.4));
    EXPECT_TRUE(advance_flight(*bench, tick * 0.4));
    EXPECT_EQ(bench->flight.frame, 1u);
    run("path stop");
    EXPECT_FALSE(advance_flight(*bench, 1));
    EXPECT_EQ(bench->flight.frame, 1u);
}

TEST_F(FlightPaths, StepsStayInsideAndAreRecorded) {
    run("path round");
    const auto stands_at = [&](std::uint32_t frame) {
        EXPECT_EQ(bench->flight.frame, frame);
        EXPECT_FALSE(bench->session.flying());
        EXPECT_EQ(bench->session.hash(), expected(bench->session, frame));
    };
    stands_at(0);
    run("path step 2; path step");
    stands_at(3);
    run("path back 2");
    stands_at(1);
    run("path back 9");
    stands_at(0);
    run("path step 99");
    stands_at(5);
    run("path start");
    stands_at(0);
    EXPECT_THROW(run("path frame 6"), InputError);
    stands_at(0);
}

TEST_F(FlightPaths, RecordingKeepsWhereTheEyeHasBeen) {
    const auto& frames = bench->session.scene().paths[0].frames;
    run("path record");
    const ViewSpec<3> from = bench->session.culling_view();
    for (const ViewSpec<3>& view : frames) {
        fly_to(*bench, view, "flight");
        EXPECT_FALSE(advance_flight(*bench, tick * 1.001));
        EXPECT_FALSE(advance_flight(*bench, tick * 1.001));  // an eye that rests adds nothing
    }
    run("path record");
    EXPECT_FALSE(bench->flight.recording);
    ASSERT_EQ(bench->flight.path.frames.size(), frames.size() + 1);
    EXPECT_EQ(bench->flight.path.frames[0], from);
    for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(bench->flight.path.frames[i + 1], frames[i]);
    EXPECT_FALSE(bench->session.flying());
    run("freeze");
    EXPECT_THROW(run("path record"), InputError);
}

TEST_F(FlightPaths, PopsAreThoseAfterTheFrameBefore) {
    const auto text_of = [](const std::vector<Marker>& markers) {
        std::string text;
        for (const Marker& marker : markers) text += std::to_string(marker.step) + " " + marker.label + "\n";
        return text;
    };
    run("path round");
    // Frames close to each other, in which much is visible twice.
    Random random(4712);
    for (ViewSpec<3>& frame : bench->flight.path.frames) {
        frame = bench->session.culling_view();
        frame.eye += random_point_3d(random, -0.15, 0.15);
    }
    const std::vector<ViewSpec<3>> frames = bench->flight.path.frames;
    std::size_t some = 0;
    for (std::uint32_t frame = 0; frame < frames.size(); ++frame) {
        go_to_frame(*bench, frame);
        EXPECT_TRUE(frame_pops(*bench).empty()) << "it flies";
        land(*bench);
        const std::string found = text_of(frame_pops(*bench));
        if (frame == 0) {
            EXPECT_EQ(found, "") << "nothing is before the first one";
            continue;
        }
        EXPECT_EQ(found, text_of(pop_markers(bench->session, frames[frame - 1]))) << "frame " << frame;
        some += !found.empty() && frame + 1 < frames.size() &&
                found != text_of(pop_markers(bench->session, frames[frame + 1]));
    }
    EXPECT_GT(some, 0u) << "frames that do not differ test nothing";
    run("eye 0.1,0.2,0.3");
    EXPECT_TRUE(frame_pops(*bench).empty()) << "not a frame of the path";
}

TEST_F(FlightPaths, AFrozenViewStaysWhileThePathMovesTheEye) {
    run("freeze");
    const ViewSpec<3> frozen = bench->session.culling_view();
    run("path round; path play");
    advance_flight(*bench, tick * 1.001);
    EXPECT_EQ(bench->session.culling_view(), frozen);
    EXPECT_EQ(bench->session.display_view(), bench->session.scene().paths[0].frames[1]);
}

}  // namespace
}  // namespace sightline
