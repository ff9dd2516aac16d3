// Word of something long, between two frames of the window and within one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/desk/open_scene.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/window_driver.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

using namespace test;

/// Of the last frame that was drawn, or of the card over it.
std::vector<std::uint8_t> pixels(int width, int height) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

TEST(WindowProgress, LeavesTheFramesAsTheyWere) {
    constexpr int width = 800, height = 500;
    Bench kept(open_scene("bottleneck", start_settings("bottleneck"), method_table<2>(), [](const auto&) {}));
    std::unique_ptr<WindowDriver<2>> driver;
    try {
        driver = std::make_unique<WindowDriver<2>>(kept.bench, width, height, stage2d);
    } catch (const WorkError& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    Window<2>& window = driver->window();
    const auto frame = [&] { window.frame(0.02); };
    ASSERT_TRUE(kept.bench.graphics.progress);
    kept.bench.graphics.progress("too early", 0.5);  // before there is a font
    for (int i = 0; i < 5; ++i) frame();
    const std::vector<std::uint8_t> before = pixels(width, height);
    SDL_Delay(600);
    for (const double share : {0.0, 0.5, 1.0, 7.0, -1.0}) kept.bench.graphics.progress("reading something", share);
    frame();
    EXPECT_EQ(pixels(width, height), before);
    // As a command does that a click within a frame runs.
    std::size_t words = 0;
    window.stage.interact = [&](Ui&, const Area&) {
        SDL_Delay(110);
        kept.bench.graphics.progress("reading something", 0.3);
        ++words;
    };
    for (int i = 0; i < 3; ++i) frame();
    EXPECT_EQ(words, 3u);
    window.stage.interact = {};
    for (int i = 0; i < 3; ++i) frame();
    EXPECT_TRUE(window.context().messages().empty()) << window.context().messages().front();
    window.ui().act("open streets");
    frame();
    EXPECT_EQ(kept.bench.session.scene().id, "streets");
}

TEST(WindowProgress, IsToldBeforeAFilmWhereverItStands) {
    Bench kept(open_scene("bottleneck", start_settings("bottleneck"), method_table<2>(), [](const auto&) {}));
    std::unique_ptr<WindowDriver<2>> driver;
    try {
        driver = std::make_unique<WindowDriver<2>>(kept.bench, 800, 500, stage2d);
    } catch (const WorkError& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    Ui& ui = driver->window().ui();
    const std::size_t before = ui.messages.size();
    ui.act("seek 3; film 1-2 /nowhere/at/all.png");
    ASSERT_EQ(ui.messages.size(), before + 1);
    EXPECT_NE(ui.messages.back().text.find("film"), std::string::npos);
    EXPECT_FALSE(ui.messages.back().bad);
    EXPECT_NE(kept.bench.session.position(), 3u) << "a frame shows the word first";
    driver->frames(1);
    EXPECT_EQ(kept.bench.session.position(), 3u);
    EXPECT_TRUE(ui.messages.back().bad) << "the folder is not there";
}

}  // namespace
}  // namespace sightline
