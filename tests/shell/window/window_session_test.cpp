// A whole session with the real program on a real display, by real keys and mouse; what it shows is read from the
// accessible text that F12 writes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/session/condition.h"
#include "core/session/state_file.h"
#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST_F(WindowSession, FromTheFirstStepToTheFigureAndBack) {
    SHOW_DISPLAY();
    start({"bottleneck"});
    if (HasFatalFailure()) return;
    ASSERT_EQ(now.step(), 0u);
    EXPECT_TRUE(now.has("Run", "ready"));

    for (int i = 0; i < 5; ++i) hands->key("Right");
    ASSERT_TRUE(is_at(5));
    for (int i = 0; i < 2; ++i) hands->key("Left");
    ASSERT_TRUE(is_at(3));

    // Drag the eye. The run is made again, at the same step.
    const std::string before_drag = now.hash();
    const Rect eye = now.screen.at("handle eye"), picture = now.screen.at("picture");
    const double to_x = eye.x + picture.w * 0.08, to_y = eye.y + picture.h * 0.05;
    ASSERT_TRUE(hands->drag(eye.x, eye.y, to_x, to_y));
    hands->move(3, 3);
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.hash() != before_drag; }));
    EXPECT_NEAR(now.screen.at("handle eye").x, to_x, 2);
    EXPECT_NEAR(now.screen.at("handle eye").y, to_y, 2);
    const std::string dragged = now.hash();
    hands->key("ctrl+z");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.hash() == before_drag; }));
    EXPECT_EQ(now.step(), 3u);
    hands->key("ctrl+y");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.hash() == dragged; }));

    // Keys are silent while text is typed.
    hands->type(":play q");
    hands->key("Escape");
    now = dump();
    ASSERT_TRUE(program->running());
    EXPECT_EQ(now.step(), 3u);
    EXPECT_EQ(now.hash(), dragged);
    EXPECT_FALSE(now.has("Run", "playing"));

    // Select cells around the eye by clicks, until one has a solidity to read.
    const auto selected = [](const Dump& d) { return d.after("Why", "Selected: cell "); };
    for (int i = 0; i < 24 && selected(now).find(", enqueued") == std::string::npos; ++i) {
        const Rect at = now.screen.at("handle eye");
        const double angle = i * 2.4, r = picture.h * (0.06 + 0.01 * i);
        hands->click(at.x + r * std::cos(angle), at.y + r * std::sin(angle));
        now = dump();
    }
    ASSERT_NE(selected(now).find(", enqueued"), std::string::npos) << now.panels["Why"];
    command("save selected.json");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "selected.json"); })) << said();
    {
        const OpenedState opened = open_state(read_file(folder / "selected.json"), "selected.json");
        const Session<2>& s = opened.session;
        ASSERT_NE(s.selected_cell, none);
        ASSERT_TRUE(selected(now).starts_with(std::to_string(s.selected_cell) + ",")) << now.panels["Why"];
        const std::string solidity = now.after("Why", "solidity (key) ");
        EXPECT_NEAR(std::stod("0" + solidity), s.mark(s.selected_cell).key, 1e-3) << now.panels["Why"];
        EXPECT_EQ(hash_text(s.hash()), now.hash());
    }

    // A breakpoint by expression, and a run to it.
    command("break rho > 0.4");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Breakpoints", "rho > 0.4"); }));
    hands->key("F5");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.step() > 3; }));
    {
        Session<2> s = open_state(read_file(folder / "selected.json"), "selected.json").session;
        const Condition<2> condition("rho > 0.4");
        s.run_until([&](const Session<2>& at) { return condition.holds(at); });
        EXPECT_EQ(now.step(), s.position());
        EXPECT_EQ(now.hash(), hash_text(s.hash()));
    }

    // Two methods beside each other, and where they part.
    command("compare layers");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Compare", "method: published | layers"); }));
    hands->key("d");
    {
        Session<2> left = open_state(read_file(folder / "selected.json"), "selected.json").session, right = left;
        Settings settings = right.settings();
        settings.method = "layers";
        right.change(settings);
        left.seek(none);
        right.seek(none);
        std::uint32_t same = 0;
        while (left.timeline().steps[same].item.id == right.timeline().steps[same].item.id) ++same;
        ASSERT_TRUE(is_at(same + 1));
    }

    // A note, and a figure whose sidecar opens the same again.
    const Rect left_eye = now.screen.at("handle eye");
    hands->key("t");
    hands->click(left_eye.x - picture.w * 0.04, left_eye.y + picture.h * 0.05);
    hands->type("too early; quit");
    hands->key("Return");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Notes", "too early; quit"); }));
    const std::string at_the_end = now.hash();
    command("shot out.pdf");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "out.pdf") && fs::exists(folder / "out.pdf.json"); })) << said();
    leave();
    Process reopened({SIGHTLINE_VIEWER2D, "--headless", "--state", "out.pdf.json", "--stats", "s.json"},
                     {{}, folder, folder / "program.txt", -1});
    ASSERT_EQ(reopened.wait(), 0) << said();
    EXPECT_EQ(nlohmann::json::parse(read_file(folder / "s.json"))["state_hash"], at_the_end);
    const OpenedState sidecar = open_state(read_file(folder / "out.pdf.json"), "out.pdf.json");
    ASSERT_EQ(sidecar.session.notes.size(), 1u);
    EXPECT_EQ(sidecar.session.notes[0].text, "too early; quit");
    ASSERT_TRUE(sidecar.other);
    EXPECT_EQ(sidecar.other->settings().method, "layers");
}

TEST_F(WindowSession, RemembersTheLastTime) {
    SHOW_DISPLAY();
    start({"rooms", "--window", "900x600"});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.has("Run", "Rooms"));
    hands->key("shift+s");  // the settings
    hands->key("ctrl+minus");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("tab settings"); }));
    command("open cars");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "Cars"); }));
    const fs::path memory = folder / "config" / "sightline" / "viewer2d.json";
    EXPECT_TRUE(await([&] { return fs::exists(memory); })) << "not written when the scene was opened";
    leave();
    const auto kept = nlohmann::json::parse(read_file(memory));
    EXPECT_EQ(kept["recent"], (std::vector<std::string>{"cars", "rooms"}));
    EXPECT_EQ(kept["desk"]["left"], "settings");
    EXPECT_EQ(kept["window"]["width"], 900);

    start({});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.has("Run", "Cars"));
    EXPECT_TRUE(now.screen.contains("tab settings"));
    leave();

    // Damaged: as at the first time, and the file is kept.
    std::ofstream(memory) << "{ \"format\": 3 ]";
    start({});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.has("Run", "Bottleneck"));
    EXPECT_FALSE(now.screen.contains("tab settings"));
    EXPECT_EQ(read_file(memory.string() + ".damaged"), "{ \"format\": 3 ]");
    leave();

    // The last scene is gone: the first one.
    auto gone = nlohmann::json::parse(read_file(memory));
    gone["recent"] = {"/nowhere/scene.json", "rooms"};
    std::ofstream(memory) << gone;
    start({});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.has("Run", "Bottleneck"));
    leave();
    EXPECT_EQ(nlohmann::json::parse(read_file(memory))["recent"], (std::vector<std::string>{"bottleneck", "rooms"}));
}

TEST_F(WindowSession, WithoutAPlaceForTheMemoryItWorksOn) {
    SHOW_DISPLAY();
    std::ofstream(folder / "config") << "a file where the folder should be";
    start({});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.has("Run", "Bottleneck"));
    leave();
    EXPECT_NE(said().find("warning: cannot make the folder"), std::string::npos) << said();
}

TEST_F(WindowSession, IsTwiceAsLargeOnADenseScreen) {
    const auto height_of_tabs = [&] { return now.screen.at("tab why").h; };
    double usual = 0;
    {
        SHOW_DISPLAY();
        start({});
        if (HasFatalFailure()) return;
        usual = height_of_tabs();
        leave();
    }
    fs::remove_all(folder / "config");
    SHOW_DISPLAY("2560x1600", 192);
    start({});
    if (HasFatalFailure()) return;
    EXPECT_NEAR(height_of_tabs(), 2 * usual, 2);
    EXPECT_NEAR(now.screen.at("picture").x + now.screen.at("picture").w + 2 * 360, 2560, 100);
    leave();
}

}  // namespace
}  // namespace sightline
