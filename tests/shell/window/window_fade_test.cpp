// What a step changes fades in, and then the window rests.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "shell/desk/open_scene.h"
#include "shell/pane/fade.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/window_driver.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

using namespace test;

TEST(WindowFade, AStepFadesInAndNothingElseDoes) {
    Bench kept(open_scene("bottleneck", start_settings("bottleneck"), method_table<2>(), [](const auto&) {}));
    std::optional<WindowDriver<2>> driver;
    try {
        driver.emplace(kept.bench, 800, 600, stage2d);
    } catch (const WorkError& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    const auto does = [&](const char* commands) {
        driver->window().ui().act(commands);
        driver->frames(1);
        const bool fades = driver->window().stage.lively();
        std::this_thread::sleep_for(std::chrono::duration<double>(1.2 * Fade::seconds));
        driver->frames(1);
        EXPECT_FALSE(driver->window().stage.lively()) << commands;
        return fades;
    };
    EXPECT_FALSE(does("step")) << "the driver shows steps at once";
    EXPECT_FALSE(does("animate"));
    EXPECT_TRUE(does("step"));
    EXPECT_TRUE(does("back"));
    EXPECT_TRUE(does("run"));
    EXPECT_FALSE(does("set show_normals=on")) << "the place in the run is the same";
    EXPECT_FALSE(does("method layers")) << "another run";
    driver->resize(700, 600);
    driver->frames(2);
    EXPECT_FALSE(driver->window().stage.lively()) << "another size";
    EXPECT_FALSE(does("animate; step"));
}

}  // namespace
}  // namespace sightline
