// The lane of frames on the bench: what each changed, and stepping into one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/frames.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "shell/commands/command_table.h"
#include "shell/desk/open_scene.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

TEST(Frames, EachCountsTheBoxesThatAStepOfItsRunStopsAt) {
    Session<2> session = open_scene("rooms", start_settings("rooms"), method_table<2>(), [](const std::string&) {});
    Workbench<2> bench{std::move(session), {}, Stop::none, false, [](const std::string&) {}};
    test::record_ahead(bench);
    run_commands(bench, "budget unlimited; method coorg-teller; set step=change; run");
    EXPECT_EQ(count_frames(bench).frames, 0u);
    const Vec<2> eye = bench.session.culling_view().eye;
    for (int i = 1; i < 6; ++i)
        run_commands(bench,
                     "frame keep; eye " + std::to_string(eye.x + 0.3 * i) + "," + std::to_string(eye.y) + "; run");
    ASSERT_EQ(count_frames(bench).frames, 6u);
    ASSERT_EQ(count_frames(bench).here, 5u);
    const auto changes = frame_changes(bench, 64);
    ASSERT_EQ(changes.size(), 6u);
    EXPECT_FALSE(changes[0].boxes);
    std::uint32_t some = 0;
    const ViewSpec<2> last = bench.session.culling_view();
    const std::uint64_t hash = bench.session.hash();
    for (const std::size_t frame : {4u, 1u, 3u, 2u, 5u}) {
        run_commands(bench, "frame " + std::to_string(frame));
        EXPECT_EQ(count_frames(bench).frames, 6u);
        EXPECT_EQ(count_frames(bench).here, frame);
        // The last step goes on to the end, where nothing changed.
        const std::uint32_t steps = bench.session.recorded();
        EXPECT_TRUE(steps == *changes[frame].boxes || steps == *changes[frame].boxes + 1)
            << steps << " and " << *changes[frame].boxes;
        EXPECT_EQ(frame_changes(bench, 64), changes);
        some += *changes[frame].boxes;
    }
    EXPECT_GT(some, 0u);
    EXPECT_EQ(bench.session.culling_view(), last);
    EXPECT_EQ(bench.session.hash(), hash);
    const auto two = frame_changes(bench, 2);
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[1], changes[5]);
    run_commands(bench, "method published");
    EXPECT_EQ(count_frames(bench).frames, 0u) << "it does not look at the frame before";
}

}  // namespace
}  // namespace sightline
