// A session with the real 3D viewer on a real display, by real keys and mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

class Window3Session : public WindowSession {
protected:
    Window3Session() { viewer = SIGHTLINE_VIEWER3D; }
};

TEST_F(Window3Session, FlyFreezeOrbitStepPickNoteExportReopen) {
    SHOW_DISPLAY();
    start({"city:10k", "--budget", "5%", "--set", "reference_size=320x240"});
    if (HasFatalFailure()) return;
    const std::uint32_t end = now.step();
    ASSERT_GT(end, 0u) << "starts at the end of the run, where there is a picture";
    const std::string at_the_end = now.hash();

    // Fly forward: another place, another run; landing records it.
    hands->key("g");
    hands->down("w");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.hash() != at_the_end; }));
    hands->up("w");
    hands->key("g");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.step() > 0 && d.hash() != at_the_end; }));
    const std::string landed = now.hash();
    const std::uint32_t last = now.step();

    // Freeze and circle: the traversal stays.
    hands->key("f");
    const Rect picture = now.screen.at("picture");
    const double x = picture.x + picture.w / 2, y = picture.y + picture.h / 2;
    hands->drag(x, y, x - 90, y + 60);
    command("zoom 0.3");  // far enough to see the frozen eye
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("frozen eye"); }));
    EXPECT_EQ(now.hash(), landed);

    // Back and forward.
    hands->key("Left");
    hands->key("Left");
    ASSERT_TRUE(is_at(last - 2));
    EXPECT_NE(now.hash(), landed);
    hands->key("Right");
    hands->key("Right");
    ASSERT_TRUE(is_at(last));
    EXPECT_EQ(now.hash(), landed);

    // Pick what lies in the middle, write a note, export, open again.
    hands->click(x, y);
    command("select last");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("selected cell"); }));
    command("note text cell:last the last one");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Notes", "the last one"); }));
    command("shot out.png");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "out.png.json"); })) << said();
    leave();
    Process reopened({SIGHTLINE_VIEWER3D, "--headless", "--state", "out.png.json", "--stats", "s.json"},
                     {{}, folder, folder / "program.txt", -1});
    ASSERT_EQ(reopened.wait(), 0) << said();
    EXPECT_EQ(nlohmann::json::parse(read_file(folder / "s.json"))["state_hash"], landed);
}

TEST_F(Window3Session, WindowsOfAlmostNoSizeAndHiddenOnesGoOn) {
    SHOW_DISPLAY();
    start({"bottleneck", "--set", "reference_size=320x240", "--set", "inset=both"});
    if (HasFatalFailure()) return;
    std::uint32_t last = now.step();
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(900, 1), std::pair(1, 700)}) {
        ASSERT_TRUE(hands->resize(w, h));
        hands->key("Left");
        ASSERT_TRUE(is_at(--last)) << w << "x" << h;
    }
    ASSERT_TRUE(hands->resize(1000, 700));
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("picture") && d.screen.at("picture").w > 300; }));
    ASSERT_TRUE(hands->hide());
    ASSERT_TRUE(hands->show());
    hands->key("Left");
    ASSERT_TRUE(is_at(last - 1));
    leave();
}

TEST_F(Window3Session, ADriverThatIsTooOldIsNamedWithWhatToInstall) {
    SHOW_DISPLAY();
    Process old({SIGHTLINE_VIEWER3D, "bottleneck"},
                {{"DISPLAY=" + xvfb->display(), "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11",
                  "HOME=" + (folder / "home").string(), "XDG_CONFIG_HOME=" + (folder / "config").string(),
                  "MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"},
                 folder,
                 folder / "program.txt",
                 -1});
    if (!await([&] { return !old.running(); }, 20)) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(old.wait(), 1);
    EXPECT_EQ(said().find("viewer3d: OpenGL 3.3 is needed; found: OpenGL 2.1"), 0u) << said();
    EXPECT_NE(said().find("libgl1-mesa-dri"), std::string::npos) << said();

    // Without any driver Mesa has its say first; X11's own last words are not the last.
    Process none(
        {SIGHTLINE_VIEWER3D, "bottleneck"},
        {{"DISPLAY=" + xvfb->display(), "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11", "HOME=" + (folder / "home").string(),
          "XDG_CONFIG_HOME=" + (folder / "config").string(), "LIBGL_DRIVERS_PATH=/nonexistent"},
         folder,
         folder / "program.txt",
         -1});
    if (!await([&] { return !none.running(); }, 20)) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(none.wait(), 1);
    EXPECT_NE(said().find("\nviewer3d: OpenGL 3.3 is needed; found: no OpenGL at all"), std::string::npos) << said();
    EXPECT_NE(said().find("libgl1-mesa-dri"), std::string::npos) << said();
}

/// The bar of a flight path, by its buttons and keys, while settings change and with two methods beside each other.
TEST_F(Window3Session, APathIsChosenPlayedSteppedAndRecorded) {
    SHOW_DISPLAY();
    start({"city:10k", "--budget", "5%", "--set", "reference_size=160x120"});
    if (HasFatalFailure()) return;
    const auto centre = [&](const std::string& name) {
        const Rect r = now.screen.at(name);
        return std::array<double, 2>{r.x + r.w / 2, r.y + r.h / 2};
    };
    const auto click = [&](const std::string& name) {
        ASSERT_TRUE(now.screen.contains(name)) << name;
        const auto [x, y] = centre(name);
        hands->click(x, y);
    };
    const auto has = [](const std::string& name) { return [name](const Dump& d) { return d.screen.contains(name); }; };
    ASSERT_FALSE(now.screen.contains("path street"));

    // The button shows the bar, with the scene's first path at its first frame.
    click("button path");
    ASSERT_TRUE(becomes(has("frame 0 of 160")));
    ASSERT_TRUE(now.screen.contains("path street"));
    ASSERT_GT(now.step(), 0u) << "a frame that stands can be stepped through";
    const std::string first = now.hash();
    hands->key("shift+Next");
    ASSERT_TRUE(becomes(has("frame 1 of 160")));
    click("button path step");
    ASSERT_TRUE(becomes(has("frame 2 of 160")));
    EXPECT_NE(now.hash(), first);
    click("button path back");
    hands->key("shift+Prior");
    ASSERT_TRUE(becomes(has("frame 0 of 160")));
    EXPECT_EQ(now.hash(), first);

    // The slider.
    const Rect frames = now.screen.at("path frames");
    const double y = frames.y + frames.h / 2;
    hands->drag(frames.x + 8, y, frames.x + frames.w / 2, y);
    ASSERT_TRUE(becomes(
        [](const Dump& d) { return d.screen.contains("frame 80 of 160") || d.screen.contains("frame 79 of 160"); }));
    ASSERT_GT(now.step(), 0u);

    // It plays on while the method and the budget change, in both sessions, and begins again at its end.
    command("compare centroid");
    command("path frame 0");
    ASSERT_TRUE(becomes(has("frame 0 of 160")));
    hands->key("shift+l");
    ASSERT_TRUE(becomes(has("button path loop, on")));
    hands->key("shift+space");
    ASSERT_TRUE(becomes(has("state flying")));
    command("method layers");
    command("budget 2%");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.screen.contains("state flying") && d.has("Run", "(layers)"); }));
    const auto frame_of = [](const Dump& d) {
        for (const auto& [name, place] : d.screen)
            if (name.starts_with("frame ") && name.ends_with(" of 160")) return std::stoi(name.substr(6));
        return -1;
    };
    const int reached = frame_of(now);
    ASSERT_TRUE(becomes([&](const Dump& d) { return frame_of(d) != reached; })) << "the path stands still";
    hands->key("Escape");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.step() > 0; }));

    // A path of one's own: recorded by flying, saved, opened.
    click("button path record");
    hands->key("g");
    hands->down("w");
    ASSERT_TRUE(becomes([](const Dump& d) {
        return std::any_of(d.screen.begin(), d.screen.end(), [](const auto& place) {
            return place.first.ends_with(" frames") && std::atoi(place.first.c_str()) > 3;
        });
    }));
    hands->up("w");
    hands->key("g");
    hands->key("shift+r");
    ASSERT_TRUE(becomes(has("button path record")));
    command("path save own.json");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "own.json"); })) << said();
    command("path open own.json");
    ASSERT_TRUE(becomes(has("path recorded")));
    leave();
}

TEST_F(Window3Session, ASplitShowsTheExactImageFlyingAndFrozen) {
    SHOW_DISPLAY("1280x720");
    start({"city:10k", "--budget", "2%", "--set", "reference_size=160x120"});
    if (HasFatalFailure()) return;
    const auto starting = [](const std::string& words) {
        return [words](const Dump& d) {
            const auto found = d.screen.lower_bound(words);
            return found != d.screen.end() && found->first.starts_with(words);
        };
    };
    ASSERT_TRUE(now.screen.contains("counters"));
    hands->key("z");
    ASSERT_TRUE(becomes(starting("the exact image, ")));
    ASSERT_TRUE(now.screen.contains("what published draws"));
    const Rect left = now.screen.at("what published draws"), right = now.screen.lower_bound("the exact image")->second;
    EXPECT_EQ(left.w, right.w) << "halves of one size";
    EXPECT_EQ(left.h, right.h);
    EXPECT_GE(right.x, left.x + left.w);
    const Rect counters = now.screen.at("counters");
    EXPECT_LE(counters.y + counters.h, left.y) << "the counters cover nothing";

    // While it flies as well, and measured when it rests.
    hands->key("g");
    hands->down("w");
    ASSERT_TRUE(becomes(starting("state flying")));
    hands->up("w");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "coverage"); }));
    ASSERT_TRUE(becomes(starting("the exact image, ")));

    // Frozen and circled, the right half stays with the frozen eye.
    hands->key("f");
    command("fly off");
    command("orbit 40,30");
    ASSERT_TRUE(becomes(starting("frozen eye: the exact image")));
    ASSERT_TRUE(now.screen.contains("seen from a different eye"));
    hands->key("z");
    ASSERT_TRUE(becomes(starting("frozen eye: wrong pixels")));
    hands->key("i");  // look through the frozen eye
    ASSERT_TRUE(becomes(starting("wrong pixels")));
    hands->key("z");
    ASSERT_TRUE(becomes([&](const Dump& d) { return !starting("wrong pixels")(d); }));
    leave();
}

}  // namespace
}  // namespace sightline
