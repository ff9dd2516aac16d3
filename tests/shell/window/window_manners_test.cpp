// What a person expects of any program, with real keys: the console's line, the list of scenes, Escape, full screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

class WindowManners : public WindowSession {
protected:
    void open(const std::vector<std::string>& arguments = {"bottleneck"}) {
        show_display();
        if (IsSkipped() || HasFatalFailure()) return;
        start(arguments);
    }
    /// What stands in the console's line.
    static std::string line_of(const Dump& dump) {
        for (const auto& [name, at] : dump.screen)
            if (name.starts_with("console ")) return name.substr(8);
        return "(closed)";
    }
    ::testing::AssertionResult line_is(const std::string& text) {
        const auto result = becomes([&](const Dump& d) { return line_of(d) == text; });
        return result ? result : ::testing::AssertionFailure() << "the line is '" << line_of(now) << "'";
    }
};

TEST_F(WindowManners, TheConsolesLine) {
    open();
    if (IsSkipped() || HasFatalFailure()) return;
    // The key that opens it leaves no letter.
    for (const auto& [key, line] : {std::pair{"u", "until "}, {"b", "bookmark "}, {"colon", ""}, {"ctrl+o", "open "}}) {
        hands->key(key);
        ASSERT_TRUE(line_is(line)) << key;
        hands->key("Escape");
        ASSERT_TRUE(line_is("(closed)")) << key;
    }
    // Ctrl+A marks it: what is typed then replaces it.
    hands->type(":nothing at all");
    ASSERT_TRUE(line_is("nothing at all"));
    hands->key("ctrl+a");
    hands->type("step 3");
    hands->key("Return");
    ASSERT_TRUE(is_at(3));
    // A wrong line stays to be read, and is replaced by what is typed next.
    hands->type(":stpe 2");
    hands->key("Return");
    ASSERT_TRUE(line_is("stpe 2"));
    hands->type("step 2");
    hands->key("Return");
    ASSERT_TRUE(is_at(5));
    ASSERT_TRUE(line_is("(closed)"));
    // What was typed before comes back, also after the line was closed; what is being typed is not lost.
    hands->type(":ste");
    hands->key("Up");
    ASSERT_TRUE(line_is("step 2"));
    hands->key("Up");
    ASSERT_TRUE(line_is("stpe 2"));
    hands->key("Up");
    ASSERT_TRUE(line_is("step 3"));
    for (int i = 0; i < 3; ++i) hands->key("Down");
    ASSERT_TRUE(line_is("ste"));
    hands->key("Escape");
    // Values are completed.
    hands->type(":set penalty=no");
    hands->key("Tab");
    ASSERT_TRUE(line_is("set penalty=none "));
    hands->key("Escape");
    leave();
}

TEST_F(WindowManners, TheListOfScenesTakesAllKeys) {
    open();
    if (IsSkipped() || HasFatalFailure()) return;
    const std::string hash = now.hash();
    hands->key("o");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("scene filter"); }));
    // Each of these does something in the window behind.
    hands->type("dkmxqqq");
    hands->key("End");
    hands->key("F5");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("no scene matches 'dkmxqqq'"); }));
    EXPECT_EQ(now.step(), 0u);
    EXPECT_EQ(now.hash(), hash);
    EXPECT_TRUE(now.has("Run", "Bottleneck"));
    hands->key("ctrl+a");
    hands->type("room");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("scene chosen rooms"); }));
    EXPECT_TRUE(now.screen.contains("scenes Scenes")) << "a heading";
    hands->key("Down");
    hands->key("Up");
    hands->key("Return");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "Rooms"); }));
    // It opens with an empty line, and Escape leaves everything as it was.
    hands->key("o");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("scene chosen bottleneck"); })) << "the first one";
    hands->key("Escape");
    ASSERT_TRUE(becomes([](const Dump& d) { return !d.screen.contains("scene filter"); }));
    EXPECT_TRUE(now.has("Run", "Rooms"));
    // Nor do letters go through a sheet that covers the picture.
    const std::string rooms = now.hash();
    for (const char* sheet : {"F1", "F2"}) {
        hands->key(sheet);
        hands->type("kw");
        hands->key("Escape");
        now = dump();
        EXPECT_EQ(now.hash(), rooms) << sheet;
        EXPECT_FALSE(now.screen.contains("handle look")) << sheet;
    }
    hands->key("Right");
    ASSERT_TRUE(is_at(1)) << "keys are the window's again";
    leave();
}

TEST_F(WindowManners, EscapeClosesOneThingAtAPress) {
    open();
    if (IsSkipped() || HasFatalFailure()) return;
    hands->key("w");
    hands->key("shift+g");
    hands->key("o");
    hands->key("Escape");
    hands->type(":step");
    hands->key("Escape");
    ASSERT_TRUE(becomes([](const Dump& d) {
        return d.screen.contains(
            "mode Cut a gap: click two points of one wall, or "
            "drag along it. V ends this.");
    })) << "the list and the console went, the tool stayed";
    hands->key("Escape");
    const auto edits = [](const Dump& d) { return d.screen.contains("handle look"); };
    ASSERT_TRUE(becomes([&](const Dump& d) {
        return edits(d) && std::none_of(d.screen.begin(), d.screen.end(),
                                        [](const auto& place) { return place.first.starts_with("mode Cut"); });
    })) << "the tool went, the edit mode stayed";
    hands->key("Escape");
    ASSERT_TRUE(becomes([&](const Dump& d) { return !edits(d); }));
    for (int i = 0; i < 3; ++i) hands->key("Escape");
    now = dump();
    EXPECT_TRUE(program->running()) << "never the program";
    leave();
}

/// Width and height of the window's content, from the widest part and the lowest.
std::array<double, 2> size_of(const Dump& dump) {
    std::array<double, 2> size{};
    for (const auto& [name, at] : dump.screen) {
        if (name.starts_with("button ")) size[0] = std::max(size[0], at.x + at.w);
        if (name == "picture") size[1] = std::max(size[1], at.y + at.h);
    }
    return size;
}

TEST_F(WindowManners, FullScreenUnderAWindowManager) {
    show_display("1600x900");
    if (IsSkipped() || HasFatalFailure()) return;
    if (!installed("evilwm")) GTEST_SKIP() << "evilwm is not installed: no window manager to ask for the full screen";
    // Its own font is in a package that need not be here; "fixed" comes with the server.
    const Process manager({"evilwm", "-fn", "fixed"},
                          {{"DISPLAY=" + xvfb->display()}, folder, folder / "manager.txt", -1});
    ASSERT_TRUE(hands->has_manager()) << read_file(folder / "manager.txt");
    start({"bottleneck", "--window", "1000x640"});
    if (HasFatalFailure()) return;
    const auto before = hands->geometry();
    ASSERT_EQ(before[2], 1000);
    ASSERT_EQ(before[3], 640);
    const std::array<double, 2> small = size_of(now);
    const double fitted = now.screen.at("picture").h;
    for (const char* back : {"F11", "Escape"}) {
        SCOPED_TRACE(back);
        hands->key("F11");
        ASSERT_TRUE(await(
            [&] {
                return hands->geometry() == std::array{0, 0, 1600, 900};
            },
            20))
            << "the whole screen is covered";
        ASSERT_TRUE(becomes([&](const Dump& d) { return size_of(d)[0] > 1500 && size_of(d)[1] > 700; }));
        EXPECT_GT(now.screen.at("picture").h, fitted * 1.3) << "the picture is fitted again";
        hands->key(back);
        ASSERT_TRUE(await([&] { return hands->geometry() == before; }, 20)) << "the old size and place";
        ASSERT_TRUE(becomes([&](const Dump& d) { return size_of(d) == small; }));
    }
    leave();
}

}  // namespace
}  // namespace sightline
