// Commands that work out beforehand what a choice by viewpoint is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/desk/frames.h"
#include "shell/desk/work_out.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::Commands;
using test::EachCommand;

/// Four boxes, each with four intervals.
constexpr const char* small_table = "set grid=2; set azimuths=4; set samples=1; method by-viewpoint";

ViewpointFact<2> fact_of(const Workbench<2>& bench) { return bench.session.traversal().viewpoint().value(); }

TEST_F(EachCommand, work_out) {
    EXPECT_THROW(run("work-out all"), InputError) << "published chooses nothing";
    run(small_table);
    EXPECT_EQ(fact_of(*bench).entries, 16u);
    EXPECT_EQ(fact_of(*bench).known, 1u);
    run("work-out region");
    EXPECT_EQ(fact_of(*bench).known, 4u);
    EXPECT_NE(said.back().find("worked out 3 entries; 4 of 16 entries"), std::string::npos) << said.back();
    const ViewpointFact<2> of_region = fact_of(*bench);
    for (const DirectionFact& direction : of_region.rose) EXPECT_NE(direction.technique, none);
    run("work-out all");
    EXPECT_EQ(fact_of(*bench).known, 16u);
    const ViewpointFact<2> of_all = fact_of(*bench);
    for (const RegionFact<2>& region : of_all.map) EXPECT_NE(region.technique, none);
    EXPECT_THROW(run("work-out some"), InputError);
}

TEST_F(EachCommand, viewpoint) {
    EXPECT_THROW(run("viewpoint next"), InputError) << "published chooses nothing";
    run(small_table);
    std::set<std::pair<std::uint32_t, std::uint32_t>> shown;
    for (std::size_t known = fact_of(*bench).known; known < 16; ++known) {
        run("viewpoint next");
        const ViewpointFact<2> fact = fact_of(*bench);
        EXPECT_EQ(fact.known, known + 1) << "one at a time";
        EXPECT_TRUE(shown.emplace(fact.region_here, fact.interval_here).second) << "the eye is where it was before";
        EXPECT_NE(said.back().find(fact.region + ", " + fact.interval + ": " + fact.techniques[fact.chosen].name),
                  std::string::npos)
            << said.back();
    }
    const ViewSpec<2> last = session().culling_view();
    run("viewpoint next");
    EXPECT_EQ(session().culling_view(), last);
    EXPECT_EQ(said.back(), "all 16 entries of the table are known");
    run("undo");
    EXPECT_NE(session().culling_view(), last);
}

TEST_F(Commands, WorkThatAWindowGoesOnWithCanBeStopped) {
    run(small_table);
    bench->attended = true;
    run("work-out all");
    EXPECT_EQ(fact_of(*bench).known, 1u) << "nothing before a frame";
    EXPECT_EQ(work_out_text(*bench), "1 of 16 entries");
    EXPECT_TRUE(advance_work_out(*bench, 0));
    const std::size_t some = fact_of(*bench).known;
    EXPECT_GT(some, 1u);
    EXPECT_LT(some, 16u);
    run("work-out stop");
    EXPECT_EQ(work_out_text(*bench), "");
    EXPECT_FALSE(advance_work_out(*bench, 0));
    EXPECT_EQ(fact_of(*bench).known, some) << "what is known stays";
    run("work-out all");
    for (int i = 0; i < 16 && bench->work_out; ++i) advance_work_out(*bench, 0);
    EXPECT_FALSE(bench->work_out);
    EXPECT_EQ(fact_of(*bench).known, 16u);
    run("work-out all");
    EXPECT_FALSE(bench->work_out) << "there is nothing to do";
}

TEST_F(Commands, WorkEndsWithTheMethodThatItIsFor) {
    run(small_table);
    bench->attended = true;
    run("work-out all; method published");
    EXPECT_EQ(work_out_text(*bench), "");
    EXPECT_FALSE(advance_work_out(*bench, 0));
    EXPECT_FALSE(bench->work_out);
}

TEST_F(Commands, FramesHaveTheTechniqueThatWasDoneInEach) {
    run(std::string(small_table) + "; set switch_ms=0; run");
    std::vector<std::string> done;
    const Vec<2> eye = session().culling_view().eye;
    for (int i = 0; i < 5; ++i) {
        if (i > 0) run("frame keep; eye " + std::to_string(eye.x + 1.5 * i) + "," + std::to_string(eye.y) + "; run");
        done.push_back(fact_of(*bench).techniques[fact_of(*bench).done].name);
    }
    const std::vector<FrameChange> changes = frame_changes(*bench, 64);
    ASSERT_EQ(changes.size(), done.size());
    for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(changes[i].technique, done[i]) << i;
}

}  // namespace
}  // namespace sightline
