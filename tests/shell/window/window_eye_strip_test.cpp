// What the eye sees, in the real window: the key, and clicks on the strip.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/draw/eye_strip.h"
#include "core/session/state_file.h"
#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST_F(WindowSession, AClickOnWhatTheEyeSeesSelectsTheSegment) {
    SHOW_DISPLAY();
    start({"rooms", "--budget", "10%", "--do", "step 60", "--set", "show_depth=on"});
    if (HasFatalFailure()) return;
    EXPECT_FALSE(now.screen.contains("strip exact"));
    hands->key("z");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("strip exact"); }));
    const Rect picture = now.screen.at("picture"), exact = now.screen.at("strip exact"),
               drawn = now.screen.at("strip drawn");
    EXPECT_GE(exact.x, picture.x);
    EXPECT_LE(exact.x + exact.w, picture.x + picture.w);
    EXPECT_GT(drawn.y, exact.y + exact.h);
    EXPECT_LE(drawn.y + drawn.h, picture.y + picture.h);
    EXPECT_GT(exact.h, 12) << "large enough to be clicked";

    command("save strip.json");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "strip.json"); })) << said();
    const Session<2> session = open_state(read_file(folder / "strip.json"), "strip.json").session;
    const EyeStrip strip = eye_strip(session);
    // The widest piece that is wrong, with another segment before it.
    const EyeStrip::Piece* wrong = nullptr;
    for (const EyeStrip::Piece& piece : strip.pieces)
        if (strip.is_wrong(piece) && piece.drawn != none &&
            (!wrong || piece.end - piece.begin > wrong->end - wrong->begin))
            wrong = &piece;
    ASSERT_NE(wrong, nullptr);
    const double x = exact.x + exact.w * (wrong->begin + wrong->end) / 2 / strip.pixels;
    const auto says = [](std::uint32_t id) {
        return [id](const Dump& d) { return d.has("Why", "Segment " + std::to_string(id) + " "); };
    };
    hands->click(x, exact.y + exact.h / 2);
    EXPECT_TRUE(becomes(says(wrong->exact))) << wrong->exact;
    hands->click(x, drawn.y + drawn.h / 2);
    EXPECT_TRUE(becomes(says(wrong->drawn))) << wrong->drawn;
    hands->click(x, (exact.y + exact.h + drawn.y) / 2);
    EXPECT_TRUE(becomes(says(wrong->exact))) << "the red mark speaks of what is missing";

    hands->key("z");
    EXPECT_TRUE(becomes([](const Dump& d) { return !d.screen.contains("strip exact"); }));
    leave();
}

}  // namespace
}  // namespace sightline
